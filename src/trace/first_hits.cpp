#include "trace/first_hits.hpp"

#include <algorithm>

#include "optics/view_place.hpp"
#include "shading/splat_light.hpp"
#include "trace/former_places.hpp"
#include "trace/trace_batch.hpp"

namespace lippmann {
namespace {

/// A ray passes at most this many surfaces that alpha makes transparent. The next hit counts as opaque.
constexpr int kMostHoles = 64;

Vec3f unit_direction(const RayHitPacket& packet, int i) {
  return {packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]};
}

/// Returns whether alpha makes the surface transparent. Glass does not count.
bool is_hole(const ShadedScene& scene, const SurfacePacket& surface, int i, float least_opacity) {
  const Material& material = scene.scene->materials[scene.material_of_instance[surface.instance[i]]];
  const auto* m = std::get_if<MetallicRoughness>(&material.surface);
  if (!m || !(m->blend || m->alpha_cutoff > 0.0f)) return false;
  const float solid = scene.path ? 1.0f : 1.0f - m->transmission;
  return surface.opacity[i] < least_opacity * solid;
}

/// An integrator that records first hits instead of light.
class FirstHits {
 public:
  FirstHits(const Shot& shot, const FrameStep* step, FrameAovs& aovs, float least_opacity)
      : scene_(shot.device.shaded()),
        beam_(shot.optics, shot.world_from_display),
        display_from_world_(inverse(shot.world_from_display)),
        mm_per_unit_(1.0f / uniform_scale(shot.world_from_display)),
        views_(shot.optics),
        aovs_(aovs),
        least_opacity_(least_opacity) {
    if (step && aovs.wants(Aov::kMotion)) former_.emplace(scene_, shot.world_from_display, *step);
  }

  void primary(CameraPacket& packet) const {
    RayPacket& rays = packet.rays.ray;
    LaneMask active = packet.active;
    SurfacePacket surface;
    Lanes left;
    LIPPMANN_FOR_LANES(i) left[i] = 1.0f;
    for (int hole = 0;; ++hole) {
      if (scene_.has_splats()) stop_at_splats(packet, left, active);
      evaluate_surfaces(scene_, packet.rays, active, Lanes{}, beam_, surface);
      if (!store(packet.rays, surface, packet.target, hole == kMostHoles, active)) return;
      for (int i = 0; i < kLanes; ++i)
        if (active.lane[i]) rays.tnear[i] = rays.tfar[i] + surface.t_near[i];
      std::copy_n(packet.reach.lane, kLanes, rays.tfar);
      scene_.trace(active, packet.rays, Coherence::kIncoherent, &active);
    }
  }
  void finish() const {}

 private:
  /// Ends each ray at the first splat behind which the transmittance is below 0.5. `left` is the transmittance so far.
  void stop_at_splats(CameraPacket& packet, Lanes& left, LaneMask& active) const {
    SplatHits hits;
    SplatLight light;
    see_splats(scene_, active, packet.rays.ray, hits, light);
    for (int i = 0; i < kLanes; ++i) {
      if (!active.lane[i]) continue;
      const auto is_half = [&](const SplatHit& hit) { return left[i] * hit.left < 0.5f; };
      const auto hit = std::find_if(hits.of(i).begin(), hits.of(i).end(), is_half);
      left[i] *= light.passed[i];
      if (hit == hits.of(i).end()) continue;
      store_splat(packet, i, *hit, light.radiance.get(i) / (1.0f - light.passed[i]));
      active.lane[i] = 0;
    }
  }

  /// Stores a splat hit, with the direction to the viewer as its normal.
  void store_splat(CameraPacket& packet, int i, const SplatHit& hit, Vec3f color) const {
    RayPacket& ray = packet.rays.ray;
    const Vec3f direction = unit_direction(packet.rays, i);
    SurfacePacket surface;
    surface.position.set(i, Vec3f(ray.org_x[i], ray.org_y[i], ray.org_z[i]) + hit.t * direction);
    surface.normal.set(i, -direction);
    surface.color.set(i, color);
    surface.instance[i] = scene_.splats.sets[scene_.splats.splats[hit.splat].set].instance;
    ray.tfar[i] = hit.t;
    store(packet.rays, surface, i, packet.target[i]);
  }

  /// Stores hits. Lanes that hit a transparent surface stay active. Returns whether there is such a lane.
  bool store(const RayHitPacket& packet, const SurfacePacket& surface, const std::uint32_t* pixel, bool last,
             LaneMask& active) const {
    bool any_hole = false;
    for (int i = 0; i < kLanes; ++i) {
      const bool hit = active.lane[i] && surface.hit.lane[i];
      const bool hole = hit && !last && is_hole(scene_, surface, i, least_opacity_);
      active.lane[i] = hole ? -1 : 0;
      any_hole |= hole;
      if (hit && !hole) store(packet, surface, i, pixel[i]);
    }
    return any_hole;
  }

  void store(const RayHitPacket& packet, const SurfacePacket& surface, int i, std::size_t pixel) const {
    const Vec3f position = surface.position.get(i);
    set(Aov::kDepth, pixel, transform_point(display_from_world_, position).z);
    set(Aov::kNormal, pixel, surface.normal.get(i));
    set(Aov::kId, pixel, static_cast<float>(surface.instance[i]));
    const Vec3d& origin = scene_.scene->origin;
    set(Aov::kPosition, pixel, origin == Vec3d(0.0) ? position : Vec3f(Vec3d(position) + origin));
    set(Aov::kRayDepth, pixel, packet.ray.tfar[i] * mm_per_unit_);
    set(Aov::kAlbedo, pixel, surface.color.get(i));
    if (former_) set_motion(packet, surface, i, pixel);
  }

  void set(Aov aov, std::size_t pixel, float value) const {
    if (aovs_.wants(aov)) aovs_[aov].data[pixel] = value;
  }
  void set(Aov aov, std::size_t pixel, Vec3f value) const {
    if (!aovs_.wants(aov)) return;
    for (std::size_t c = 0; c < 3; ++c) aovs_[aov].data[3 * pixel + c] = value[static_cast<int>(c)];
  }

  void set_motion(const RayHitPacket& packet, const SurfacePacket& surface, int i, std::size_t pixel) const {
    const std::optional<Vec3f> before = former_->of(packet, surface, i);
    if (!before) return;
    const Vec3f origin(packet.ray.org_x[i], packet.ray.org_y[i], packet.ray.org_z[i]);
    const Ray ray{transform_point(display_from_world_, origin),
                  glm::normalize(transform_vector(display_from_world_, unit_direction(packet, i)))};
    const std::optional<Vec2f> from = views_.place_in_view(ray, *before);
    const std::optional<Vec2f> to = views_.place_in_view(ray, transform_point(display_from_world_, surface.position.get(i)));
    if (!from || !to) return;
    for (std::size_t c = 0; c < 2; ++c) aovs_[Aov::kMotion].data[2 * pixel + c] = (*to - *from)[static_cast<int>(c)];
  }

  const ShadedScene& scene_;
  BeamFootprint beam_;
  Affine3f display_from_world_;
  float mm_per_unit_;
  ViewPlaces views_;
  std::optional<FormerPlaces> former_;
  FrameAovs& aovs_;
  float least_opacity_;
};

}  // namespace

void find_first_hits(const Shot& shot, RayOrder order, const FrameStep* step, const ThreadPool& pool, FrameAovs& aovs,
                     float least_opacity) {
  if (!aovs.wants_any(AovOrigin::kFirstHit)) return;
  for (std::size_t a = 0; a < kAovs; ++a)
    if (const auto aov = static_cast<Aov>(a); aovs.wants(aov) && info_of(aov).origin == AovOrigin::kFirstHit)
      aovs.allocate(aov, film_size(shot));
  const FirstHits hits(shot, step, aovs, least_opacity);
  trace_centres(shot, order, pool, hits);
}

}  // namespace lippmann
