// The state of a path between two vertices.
#pragma once

#include "device/ray_scene.hpp"
#include "shading/light_tree.hpp"
#include "shading/shading_point.hpp"
#include "trace/camera_packet.hpp"

namespace lippmann {

struct PathRay {
  Vec3f origin{0.0f}, direction{0.0f}, throughput{1.0f};
  Vec3f lit_side{0.0f};
  float near_share = -1.0f;
  float t_near = 0.0f, path_length = 0.0f;
  float scattered_at = 0.0f;  ///< path length at the last change of direction; 0 if there was no change yet
  float density = kInfinity;  ///< probability density of `direction`; kInfinity for Dirac lobes and camera rays
  std::uint32_t pixel = 0;
  std::uint32_t seed = 0, index = 0;
  std::uint16_t depth = 0;  ///< number of vertices so far
  bool spread : 1 = false;
  bool one_color : 1 = false;
  bool through_wall : 1 = false;
  /// Number of vertices and passed surfaces, which selects the random numbers of the next vertex.
  std::uint16_t events : 13 = 0;
  std::uint16_t medium = kNoMedium;

  bool has_met_nothing() const { return depth == 0 && !through_wall; }
  bool has_scattered() const { return scattered_at > 0.0f; }
  /// Returns the number of surfaces that have changed the light. A wall before the first vertex counts as one surface.
  int surfaces() const { return depth > 0 || !through_wall ? depth : 1; }
};

/// Maximum number of vertices and passed surfaces of a path.
inline constexpr int kMostEvents = 1024;
/// The pairs of random numbers of a vertex: for the light and the lobe, for the point on the light, for the direction, and for
/// Russian roulette and coverage.
inline constexpr std::uint32_t kChoicePair = 0, kOnLightPair = 1, kWayPair = 2, kCoveragePair = 3, kPairsPerEvent = 4;

inline PathRay camera_path_ray(const CameraPacket& packet, int i, std::uint32_t seed) {
  const RayPacket& rays = packet.rays.ray;
  PathRay ray;
  ray.origin = {rays.org_x[i], rays.org_y[i], rays.org_z[i]};
  ray.direction = {rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]};
  ray.pixel = packet.target[i];
  ray.seed = seed, ray.index = packet.sample[i];
  return ray;
}

inline PathRay passed(PathRay ray, const ShadingPoint& point, float length) {
  ray.origin = point.position;
  ray.t_near = point.t_near;
  ray.path_length = length;
  ++ray.events;
  return ray;
}

/// Continues `ray` from `point` in a sampled direction. `length` is the path length at the point. Unless sample.straight is
/// set, the caller must set lit_side and near_share.
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
  // Straight transmission keeps the direction and density of the last vertex, because that vertex's shadow rays pass this
  // surface too.
  if (sample.straight) return;
  ray.direction = sample.direction;
  ray.density = sample.density, ray.scattered_at = length;
}

/// Returns the point for which the last vertex sampled lights.
inline LightReceiver last_receiver(const PathRay& ray) {
  return {ray.origin - (ray.path_length - ray.scattered_at) * ray.direction, ray.lit_side, ray.near_share};
}

inline float largest(Vec3f v) { return std::max({v.x, v.y, v.z}); }

inline bool is_finite(Vec3f v) { return std::isfinite(v.x + v.y + v.z); }

}  // namespace lippmann
