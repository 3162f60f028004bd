#include "device/ray_scene.hpp"

#include <algorithm>

#include "device/embree_scene.hpp"
#include "device/splat_geometry.hpp"
#include "scene/deform.hpp"

namespace lippmann {

LIPPMANN_MULTIVERSION void clear_hits(RayHitPacket& packet) {
  make_ready(packet.ray);
  LIPPMANN_FOR_LANES(i) {
    packet.hit.geomID[i] = kNoId;
    packet.hit.instID[0][i] = kNoId;
  }
}

namespace {

LIPPMANN_INLINE LaneRay lane_ray(const RayPacket& ray, int i) {
  return {ray.org_x[i], ray.org_y[i], ray.org_z[i], ray.dir_x[i], ray.dir_y[i], ray.dir_z[i], ray.tnear[i], ray.tfar[i]};
}

LIPPMANN_INLINE void record_hit(RayHitPacket& packet, const LaneMask& active, int i, float t, unsigned id) {
  const bool hit = (active.lane[i] != 0) & (t < kInfinity);
  packet.ray.tfar[i] = hit ? t : packet.ray.tfar[i];
  packet.hit.geomID[i] = hit ? id : packet.hit.geomID[i];
  packet.hit.instID[0][i] = hit ? kNoId : packet.hit.instID[0][i];
}

LIPPMANN_MULTIVERSION void meet_planes(const WorldPlaneRecord* planes, std::size_t count, const LaneMask& active,
                                       RayHitPacket& packet) {
  for (std::size_t p = 0; p < count; ++p) {
    const WorldPlane plane = planes[p].plane;
    const unsigned id = kPlaneId + static_cast<unsigned>(p);
    LIPPMANN_FOR_LANES(i) record_hit(packet, active, i, distance(plane, lane_ray(packet.ray, i)), id);
  }
}

LIPPMANN_INLINE void hide(const LaneMask& of_cameras, RayPacket& rays) {
  LIPPMANN_FOR_LANES(i) rays.mask[i] = of_cameras.lane[i] != 0 ? kCameraRay : ~0u;
}

/// Returns whether the line of any ray touches `ball`, the sphere of a visible light. This test is much cheaper than an
/// intersection, and most packets miss all lights.
LIPPMANN_INLINE int points_at(const WorldSphere ball, const RayPacket& rays) {
  int any = 0;
  LIPPMANN_FOR_LANES(i) any |= discriminant(ball, lane_ray(rays, i)) >= 0.0f ? -1 : 0;
  return any;
}

LIPPMANN_MULTIVERSION void meet_lights(const WorldSphere* lights, std::size_t count, const LaneMask& active,
                                       RayHitPacket& packet) {
  for (std::size_t l = 0; l < count; ++l) {
    const WorldSphere ball = lights[l];
    if (!(ball.radius > 0.0f) || !points_at(ball, packet.ray)) continue;
    const unsigned id = kLightId + static_cast<unsigned>(l);
    LIPPMANN_FOR_LANES(i) record_hit(packet, active, i, distance(ball, lane_ray(packet.ray, i)), id);
  }
}

/// Ends the active rays that cross an opaque plane, by setting tfar to -inf. Transparent planes reduce the transmittance
/// instead. Sets `lit` to the lanes whose rays have not ended. Returns whether any ray has not ended.
LIPPMANN_MULTIVERSION int cross_planes(const WorldPlaneRecord* planes, std::size_t count, const LaneMask& active,
                                       RayPacket& rays, Lanes& transmittance, LaneMask& lit) {
  for (std::size_t p = 0; p < count; ++p) {
    const WorldPlane plane = planes[p].plane;
    const float passes = planes[p].transmittance, ends = passes > 0.0f ? kInfinity : -kInfinity;
    LIPPMANN_FOR_LANES(i) {
      const bool crossed = (active.lane[i] != 0) & (distance(plane, lane_ray(rays, i)) < kInfinity);
      transmittance[i] *= crossed ? passes : 1.0f;
      rays.tfar[i] = std::min(rays.tfar[i], crossed ? ends : kInfinity);
    }
  }
  int any = 0;
  LIPPMANN_FOR_LANES(i) {
    lit.lane[i] = ((active.lane[i] != 0) & (rays.tfar[i] >= 0.0f)) ? -1 : 0;
    any |= lit.lane[i];
  }
  return any;
}

// Returns the distance at which secondary rays start. For Tachyon scenes, it is 1e-4, as measured on Tachyon's images.
// Otherwise it is about ten times the rounding error of a hit point.
float choose_t_near(const Scene& scene, const Bounds3f& b) {
  if (scene.encoding == Encoding::kTachyonTruncate) return 1e-4f;
  return b.empty() ? 1e-4f : 1e-5f * glm::length(b.size());
}

float largest_coordinate(const Bounds3f& b) {
  if (b.empty()) return 1.0f;
  const Vec3f corner = glm::max(glm::abs(b.lower), glm::abs(b.upper));
  return std::max({corner.x, corner.y, corner.z});
}

std::vector<WorldSphere> visible_lights_of(const Scene& scene, const ResolvedScene& resolved) {
  std::vector<WorldSphere> balls;
  for (const Light& light : scene.lights) {
    const Vec3f at = resolved.of(light.node).translation;
    balls.push_back({at.x, at.y, at.z, light.visible_radius});
  }
  return balls;
}

SceneGeometry geometry_of(const Scene& scene, const ResolvedScene& resolved) {
  SceneGeometry geometry;
  geometry.scene = &scene;
  geometry.tachyon = scene.encoding == Encoding::kTachyonTruncate;
  geometry.instance_moves = moving_instances(scene);
  for (const Instance& instance : scene.instances) {
    geometry.hides_from_cameras |= instance.hidden_from_cameras;
    geometry.hides_from_shadows |= instance.casts_no_shadow;
    geometry.has_shadows |= !instance.casts_no_shadow;
  }
  geometry.visible_lights = visible_lights_of(scene, resolved);
  geometry.any_visible_light = std::any_of(geometry.visible_lights.begin(), geometry.visible_lights.end(),
                                           [](const WorldSphere& light) { return light.radius > 0.0f; });
  const Bounds3f bounds = finite_bounds(scene, resolved);
  geometry.secondary_t_near = choose_t_near(scene, bounds);
  geometry.size = largest_coordinate(bounds);
  geometry.radius = bounds.empty() ? 1.0f : std::max(0.5f * glm::length(bounds.size()), 1e-6f);
  return geometry;
}

}  // namespace

RayScene::RayScene(const Scene& described, const ResolvedScene& resolved, const ShadowMaterials& materials,
                   const ThreadPool& pool)
    : SceneGeometry(geometry_of(described, resolved)), embree_(std::make_unique<Embree>()) {
  embree_->device = make_embree_device(pool.threads(), embree_->memory);
  embree_->native_width = native_packet_width(embree_->device.get());
  build_scene({*this, *embree_}, resolved, materials, pool);
}

RayScene::~RayScene() = default;

void RayScene::update(const ResolvedScene& resolved, const ThreadPool& pool) {
  visible_lights = visible_lights_of(*scene, resolved);
  move_scene({*this, *embree_}, resolved, pool);
}

void RayScene::trace(const LaneMask& active, RayHitPacket& packet, Coherence coherence, const LaneMask* of_cameras) const {
  clear_hits(packet);
  if (of_cameras && hides_from_cameras) hide(*of_cameras, packet.ray);
  if (!planes.empty()) meet_planes(planes.data(), planes.size(), active, packet);
  const LaneMask sound = sound_lanes(packet.ray, reach, active);
  if (embree_->has_fixed) intersect(embree_->fixed.get(), embree_->native_width, sound, packet, coherence);
  if (embree_->has_moving) intersect(embree_->moving.get(), embree_->native_width, sound, packet, coherence);
  if (any_visible_light) meet_lights(visible_lights.data(), visible_lights.size(), active, packet);
}

void RayScene::meet_splats(const LaneMask& active, const RayPacket& rays, SplatHits& hits) const {
  hits.clear();
  RayHitPacket packet;
  packet.ray = rays;
  make_ready(packet.ray);
  collect_splats(embree_->splats.get(), embree_->native_width, sound_lanes(rays, reach, active), packet, hits);
}

void RayScene::trace_shadows(LaneMask& active, RayPacket& rays, Transmittance& transmittance) const {
  transmittance.is_tinted = false;
  active = sound_lanes(rays, reach, active);
  if (!has_shadows) return;
  LaneMask lit = active;
  if (!planes.empty() && !cross_planes(planes.data(), planes.size(), active, rays, transmittance.white, lit)) return;
  if (hides_from_shadows) std::fill_n(rays.mask, kLanes, kShadowRay);
  ShadowContext context;
  context.geometry = this;
  std::copy_n(transmittance.white.lane, kLanes, context.transmittance);
  if (embree_->has_fixed) occluded(embree_->fixed.get(), embree_->native_width, lit, rays, context);
  if (embree_->has_moving && (!embree_->has_fixed || cross_planes(nullptr, 0, active, rays, transmittance.white, lit)))
    occluded(embree_->moving.get(), embree_->native_width, lit, rays, context);
  std::copy_n(context.transmittance, kLanes, transmittance.white.lane);
  if (!context.is_tinted) return;
  transmittance.tint = context.tint;
  transmittance.is_tinted = true;
}

}  // namespace lippmann
