// A path on its way between two surfaces.
#pragma once

#include "device/ray_scene.hpp"
#include "shading/light_tree.hpp"
#include "shading/shading_point.hpp"
#include "trace/camera_packet.hpp"

namespace lippmann {

struct PathRay {
  Vec3f origin{0.0f}, direction{0.0f}, throughput{1.0f};
  Vec3f lit_side{0.0f};      ///< LightReceiver::normal at the last scattering
  float near_share = -1.0f;  ///< LightReceiver::near_share there
  float t_near = 0.0f, path_length = 0.0f;
  float scattered_at = 0.0f;  ///< path length at the last scattering
  float density = kInfinity;  ///< density of `direction` at the last scattering; kInfinity: a Dirac lobe's, or from the lens
  std::uint32_t pixel = 0;    ///< where its light goes
  std::uint32_t seed = 0, index = 0;  ///< decide its random numbers (transport/sampler.hpp)
  std::uint16_t depth = 0;            ///< vertices on surfaces so far
  bool spread : 1 = false;            ///< scattered by other than Dirac lobes: textures need not be sharp
  bool one_color : 1 = false;         ///< it carries one colour alone, as a surface has dispersed it
  bool through_wall : 1 = false;      ///< has gone straight through a wall, which is no vertex
  std::uint16_t events : 13 = 0;      ///< vertices, passed surfaces included: what the random numbers go by
  std::uint16_t medium = kNoMedium;   ///< the medium that it is in

  bool has_met_nothing() const { return depth == 0 && !through_wall; }
  bool has_scattered() const { return scattered_at > 0.0f; }
  /// Surfaces that have shaped its light; a wall before the first vertex makes it no light that is seen as it is.
  int surfaces() const { return depth > 0 || !through_wall ? depth : 1; }
};

/// A surface that lets light pass is no vertex of a path, but however many of them there are, it must come to an end.
inline constexpr int kMostEvents = 1024;
/// Pairs of random numbers at each vertex: which light and lobe; where on the light; which way; roulette and coverage.
inline constexpr std::uint32_t kChoicePair = 0, kOnLightPair = 1, kWayPair = 2, kCoveragePair = 3, kPairsPerEvent = 4;

/// Lane i of camera rays, with the seed of its random numbers.
inline PathRay camera_path_ray(const CameraPacket& packet, int i, std::uint32_t seed) {
  const RayPacket& rays = packet.rays.ray;
  PathRay ray;
  ray.origin = {rays.org_x[i], rays.org_y[i], rays.org_z[i]};
  ray.direction = {rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]};
  ray.pixel = packet.target[i];
  ray.seed = seed, ray.index = packet.sample[i];
  return ray;
}

/// `ray` beyond a point that it passes as if nothing were there, `length` from the path's start.
inline PathRay passed(PathRay ray, const ShadingPoint& point, float length) {
  ray.origin = point.position;
  ray.t_near = point.t_near;
  ray.path_length = length;
  ++ray.events;
  return ray;
}

/// Sends `ray` on from a point at `length`, in a direction that was drawn there, with this throughput. Unless it goes straight
/// on, the caller sets lit_side and near_share.
inline void scatter(PathRay& ray, const ShadingPoint& point, const BsdfSample& sample, Vec3f throughput, float length) {
  ray.origin = point.position;
  ray.throughput = throughput;
  ray.t_near = point.t_near, ray.path_length = length;
  ++ray.events;
  if (sample.is_vertex)
    ++ray.depth;
  else
    ray.through_wall = true;
  ray.spread |= !sample.is_delta();
  if (sample.transmitted && point.behind != kSameMedium) ray.medium = point.behind;
  // What shines straight behind is reached by the last vertex's shadow rays, too.
  if (sample.straight) return;
  ray.direction = sample.direction;
  ray.density = sample.density, ray.scattered_at = length;
}

/// The point where `ray` has scattered last, as it asked for lights there.
inline LightReceiver last_receiver(const PathRay& ray) {
  return {ray.origin - (ray.path_length - ray.scattered_at) * ray.direction, ray.lit_side, ray.near_share};
}

inline float largest(Vec3f v) { return std::max({v.x, v.y, v.z}); }

inline bool is_finite(Vec3f v) { return std::isfinite(v.x + v.y + v.z); }

}  // namespace lippmann
