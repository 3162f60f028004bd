#include "trace/thin_lens.hpp"

#include "core/random.hpp"
#include "transport/sampler.hpp"
#include "transport/sampling.hpp"

namespace lippmann {
namespace {

/// Salt of the hash that decorrelates samples on the lens from other samples.
constexpr std::uint32_t kLensSalt = 0x6c656e73u;

void lens_places(const LensLanes& lanes, std::uint32_t seed, float* x, float* y) {
  PathPairs places;
  LIPPMANN_FOR_LANES(i) {
    places.seed[i] = hash(seed, lanes.pixel[i], kLensSalt);
    places.index[i] = lanes.sample[i];
    places.first[i] = 0;
  }
  sample_pairs(places, 0, x, y);
}

float unit_scale(const Affine3f& world_from_display) { return glm::length(world_from_display.linear[0]); }

}  // namespace

ThinLens::ThinLens(const Optics& optics, const Affine3f& world_from_display, const ViewLens& lens, std::uint32_t seed)
    : radius_(0.5f * lens.aperture_mm),
      seed_(seed),
      right_(world_from_display.linear[0]),
      up_(world_from_display.linear[1]),
      forward_(-glm::normalize(world_from_display.linear[2])) {
  const float distance = viewing_distance_mm(optics), to_focus = distance - lens.focal_plane_mm;
  origin_share_ = (resolved_z_front_mm(optics) - lens.focal_plane_mm) / to_focus;
  inverse_focus_ = 1.0f / (to_focus * unit_scale(world_from_display));
}

// Each ray starts on the lens, and crosses the original pinhole ray in the focal plane.
void ThinLens::spread(const LensLanes& lanes, RayPacket& rays) const {
  alignas(64) float u[kLanes], v[kLanes];
  lens_places(lanes, seed_, u, v);
  for (int i = 0; i < kLanes; ++i) {
    const Vec2f on_lens = radius_ * sample_disc({u[i], v[i]});
    const Vec3f step = on_lens.x * right_ + on_lens.y * up_;
    const Vec3f pinhole(rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]);
    const float cosine = glm::dot(pinhole, forward_);
    const Vec3f per_depth = pinhole / cosine - inverse_focus_ * step;
    const Vec3f direction = glm::normalize(per_depth);
    rays.org_x[i] += origin_share_ * step.x, rays.org_y[i] += origin_share_ * step.y, rays.org_z[i] += origin_share_ * step.z;
    rays.dir_x[i] = direction.x, rays.dir_y[i] = direction.y, rays.dir_z[i] = direction.z;
    rays.tfar[i] *= cosine * glm::length(per_depth);  // the ray ends at the same depth as before
  }
}

}  // namespace lippmann
