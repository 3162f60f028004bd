// Phong's surfaces of a packet, side by side: what FinalGather::scatter() does for one.
#include "device/ray_scene.hpp"
#include "radiance/final_gather.hpp"

namespace lippmann {
namespace {

/// Shadow rays of a packet are traced as they come where there are so many; fewer wait for others.
constexpr int kNearlyFull = 12;

}  // namespace

LaneMask FinalGather::phong_lanes() const {
  LaneMask lanes{};
  if (!samples_points_alone_ || !surface_.any_hit) return lanes;
  for (int i = 0; i < kLanes; ++i)
    if (surface_.hit.lane[i] && scene_.materials.materials[scene_.material_of_instance[surface_.instance[i]]].is_whole)
      lanes.lane[i] = -1;
  return lanes;
}

void FinalGather::shade_phong(const RayHitPacket& packet, LaneMask lanes, const PathRay* rays) {
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i]) lanes_.set(i, rays[i]);
  evaluate_phong(surface_, scene_.tachyon, lanes, phong_);
  if (film_.surfaces)
    for (int i = 0; i < kLanes; ++i)
      if (lanes.lane[i]) describe_first(shading_point(scene_, surface_, i), i, rays[i]);
  if (phong_.any_emission)
    for (int i = 0; i < kLanes; ++i)
      if (lanes.lane[i] && phong_.emission.get(i) != Vec3f(0.0f)) add_emission(packet, i, rays[i], phong_.emission.get(i));
  LIPPMANN_FOR_LANES(i) lanes.lane[i] = lanes_.depth[i] < params_.max_depth ? lanes.lane[i] : 0;
  for (std::size_t l = 0; l < scene_.lights.size(); ++l) light_phong(packet.ray, lanes, l);
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i] && phong_.diffuse.get(i) != Vec3f(0.0f))
      ask_cache(packet, i, rays[i], surface_.normal.get(i), phong_.diffuse.get(i), rays[i].path_length + packet.ray.tfar[i]);
  if (phong_.any_gloss) reflect_phong(packet, lanes, rays);
}

void FinalGather::light_phong(const RayPacket& view, const LaneMask& lanes, std::size_t light) {
  const WhittedLight& from = scene_.lights[light];
  aim_at_light(from, surface_, 0.0f, shadow_);
  Lanes3 radiance;
  const Vec3f irradiance = lights().unit() * from.color;
  const int count = reflect_light({surface_, phong_, lanes_, view, lanes}, irradiance, shadow_, radiance);
  if (count == 0) return;
  if (count < kNearlyFull) {
    for (int i = 0; i < kLanes; ++i)
      if (shadow_.active.lane[i]) to_point_[light].push(shadow_, i, radiance.get(i), lanes_.pixel[i], lanes_.depth[i] + 1);
    return;
  }
  counts_.shadow += static_cast<std::uint64_t>(count);
  scene_.trace_shadows(shadow_.active, shadow_.rays, shadow_.transmittance);
  for (int i = 0; i < kLanes; ++i)
    if (shadow_.active.lane[i] && shadow_.rays.tfar[i] >= 0.0f)
      add_traced(lanes_.pixel[i], radiance.get(i) * shadow_.transmittance.at(i), lanes_.depth[i] + 1);
}

void FinalGather::reflect_phong(const RayHitPacket& packet, const LaneMask& lanes, const PathRay* rays) {
  Lanes survival, lobe;
  sample_pairs(lanes_.numbers, kChoicePair, survival.lane, lobe.lane);
  GlossyRays glossy;
  reflect_gloss({surface_, phong_, lanes_, packet.ray, lanes}, lobe, survival, kFaint, glossy);
  for (int i = 0; i < kLanes; ++i) {
    if (!glossy.active.lane[i]) continue;
    BsdfSample sample;
    sample.direction = glossy.direction.get(i), sample.density = kInfinity, sample.straight = glossy.straight.lane[i] != 0;
    go_on(rays[i], shading_point(scene_, surface_, i), Vec3f(0.0f), sample, glossy.throughput.get(i),
          rays[i].path_length + packet.ray.tfar[i], counts_.reflection);
  }
}

}  // namespace lippmann
