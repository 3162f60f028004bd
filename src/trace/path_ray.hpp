// The state of a path between two vertices.
#pragma once

#include "device/ray_scene.hpp"
#include "shading/light_tree.hpp"
#include "shading/shading_point.hpp"
#include "trace/camera_packet.hpp"

namespace lippmann {

struct PathRay {
  Vec3f origin{0.0f}, direction{0.0f}, throughput{1.0f};
  Vec3f lit_side{0.0f};      ///< LightReceiver::normal at the last change of direction
  float near_share = -1.0f;  ///< LightReceiver::near_share at the last change of direction
  float t_near = 0.0f, path_length = 0.0f;
  float scattered_at = 0.0f;  ///< path length at the last change of direction; 0 before the first
  float density = kInfinity;  ///< density with which `direction` was sampled; kInfinity for Dirac lobes and camera rays
  std::uint32_t pixel = 0;
  std::uint32_t seed = 0, index = 0;  ///< seed and index of the random numbers (transport/sampler.hpp)
  std::uint16_t depth = 0;            ///< number of vertices so far
  bool spread : 1 = false;            ///< has been scattered by a lobe that is not a Dirac lobe, so textures need less detail
  bool one_color : 1 = false;         ///< has only one colour channel, because a surface has dispersed the light
  bool through_wall : 1 = false;      ///< has passed straight through a thin wall, which does not count as a vertex
  /// Number of vertices and passed surfaces so far; selects the random numbers of the next vertex.
  std::uint16_t events : 13 = 0;
  std::uint16_t medium = kNoMedium;  ///< medium in which the ray travels

  bool has_met_nothing() const { return depth == 0 && !through_wall; }
  bool has_scattered() const { return scattered_at > 0.0f; }
  /// Returns the number of surfaces that have changed the light. A wall before the first vertex counts as one surface.
  int surfaces() const { return depth > 0 || !through_wall ? depth : 1; }
};

/// Maximum number of vertices and passed surfaces of a path. The maximum depth is no limit for passed surfaces, because they
/// are not vertices.
inline constexpr int kMostEvents = 1024;
/// Indices of the random number pairs of a vertex. kChoicePair chooses the light and the lobe, kOnLightPair the point on the
/// light, and kWayPair the direction. kCoveragePair decides Russian roulette and coverage.
inline constexpr std::uint32_t kChoicePair = 0, kOnLightPair = 1, kWayPair = 2, kCoveragePair = 3, kPairsPerEvent = 4;

/// Returns the path that starts with lane i of camera rays. `seed` becomes the seed of its random numbers.
inline PathRay camera_path_ray(const CameraPacket& packet, int i, std::uint32_t seed) {
  const RayPacket& rays = packet.rays.ray;
  PathRay ray;
  ray.origin = {rays.org_x[i], rays.org_y[i], rays.org_z[i]};
  ray.direction = {rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]};
  ray.pixel = packet.target[i];
  ray.seed = seed, ray.index = packet.sample[i];
  return ray;
}

/// Returns the continuation of `ray` behind a point that the ray passes unchanged. `length` is the path length at the point.
inline PathRay passed(PathRay ray, const ShadingPoint& point, float length) {
  ray.origin = point.position;
  ray.t_near = point.t_near;
  ray.path_length = length;
  ++ray.events;
  return ray;
}

/// Continues `ray` from `point` in a sampled direction with the given throughput. `length` is the path length at the point.
/// Unless sample.straight is set, the caller must set lit_side and near_share.
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
  // Straight transmission keeps the direction and density of the last vertex. Shadow rays of that vertex pass this surface too,
  // so multiple importance sampling needs the original density.
  if (sample.straight) return;
  ray.direction = sample.direction;
  ray.density = sample.density, ray.scattered_at = length;
}

/// Returns the receiver for which the vertex at the last change of direction sampled lights.
inline LightReceiver last_receiver(const PathRay& ray) {
  return {ray.origin - (ray.path_length - ray.scattered_at) * ray.direction, ray.lit_side, ray.near_share};
}

inline float largest(Vec3f v) { return std::max({v.x, v.y, v.z}); }

inline bool is_finite(Vec3f v) { return std::isfinite(v.x + v.y + v.z); }

}  // namespace lippmann
