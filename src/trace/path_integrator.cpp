#include "trace/path_integrator.hpp"

#include "trace/noisy_frame.hpp"

namespace lippmann {
namespace {

/// Paths are first put to Russian roulette where they leave this vertex.
constexpr int kRouletteDepth = 3;

}  // namespace

PathIntegrator::PathIntegrator(const ShadedScene& scene, const BeamFootprint& beam, const PathParams& params,
                               const PathFilm& film)
    : PathTracer(scene, beam, params, film) {
  if (film.noise) noise_weights_ = weights_of_halves(params.spp);
}

void PathIntegrator::begin(int sample) {
  noise_weight_ = noise_weights_[is_of_second_half(static_cast<std::uint32_t>(sample))];
}

LaneMask PathIntegrator::begin_packet(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
  if (probe_) watch_packet(packet, active, rays);
  if (!surface_.any_hit) return active;
  bool with_roulette = false;
  for (int i = 0; i < kLanes; ++i) with_roulette |= surface_.hit.lane[i] && rays[i].depth + 1 >= kRouletteDepth;
  draw_numbers(rays, with_roulette || surface_.any_see_through);
  return active;
}

void PathIntegrator::scatter(const RayHitPacket& packet, const PathRay* rays) {
  const LaneMask& lanes = vertices_.active;
  make_bsdfs(packet);
  ask_lights(
      lanes, [&](int i) { return light_for(i, rays[i]); },
      [&](int i, const LightSample& light, const BsdfValue& value) { shine(i, light, value, rays[i]); });
  BsdfSamples samples;
  vertices_.bsdfs.sample(lanes, numbers(kChoicePair).y, numbers(kWayPair).x, numbers(kWayPair).y, samples);
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i])
      if (const std::optional<BsdfSample> sample = samples.get(i)) go_on(i, rays[i], *sample);
}

void PathIntegrator::go_on(int i, const PathRay& ray, const BsdfSample& sample) {
  const ShadingPoint& point = vertices_.point(i);
  if (!is_possible(point, sample.direction, sample.transmitted)) return;
  Vec3f throughput = ray.throughput * sample.weight;
  if (ray.depth + 1 >= kRouletteDepth &&
      !survives(throughput, std::min(0.95f, largest(throughput)), numbers(ray, i, kCoveragePair).x))
    return;
  PathRay* const next = PathTracer::go_on(ray, point, vertices_.bsdfs.lit_side(i, point.normal), sample, throughput,
                                          vertices_.lengths[i], sample.is_delta() ? counts_.reflection : counts_.indirect);
  if (next && !sample.straight) next->near_share = near_share_[i];
}

std::optional<LightSample> PathIntegrator::light_for(int i, const PathRay& ray) {
  const float pick = numbers(ray, i, kChoicePair).x;
  LightReceiver at = vertices_.receiver(i);
  near_share_[i] = at.near_share = lights().near_share(at);
  if (lights().asks_sky_often() && lights().picks_sky(at, pick))
    return LightTable::sky_sample(sky_draws(), i, lights().chance(kSkyLight, at));
  return lights().sample(at, pick, numbers(ray, i, kOnLightPair));
}

void PathIntegrator::shine(int i, const LightSample& light, const BsdfValue& value, const PathRay& ray) {
  const ShadingPoint& point = vertices_.point(i);
  if (!may_shine(point, light.direction, value.transmitted)) return;
  Vec3f radiance = light.is_point() ? (value.cosine_f + vertices_.bsdfs.highlight(i, light.direction)) * light.radiance
                                    : from_wide_light(i, light, value);
  radiance *= ray.throughput;
  if (radiance == Vec3f(0.0f) || !is_finite(radiance)) return;
  shadow_rays_.push(point, light, clamped(radiance, ray.depth + 1), ray.pixel, ray.depth + 1);
}

/// No path goes behind the facet by itself. There light is asked for alone, which is too noisy for gloss.
Vec3f PathIntegrator::from_wide_light(int i, const LightSample& light, const BsdfValue& value) const {
  const Vec3f per_density = light.radiance / light.density;
  Vec3f f = value.cosine_f * power_heuristic(light.density, value.density);
  if (vertices_.point(i).rises_to(light.direction))
    f = vertices_.bsdfs.diffuse_albedo(i) * vertices_.bsdfs.evaluate_diffuse(i, light.direction).cosine_f;
  if (light.is_lamp) f += vertices_.bsdfs.highlight(i, light.direction);
  return f * per_density;
}

void PathIntegrator::trace_shadow_rays() {
  if (probe_)
    shadow_rays_.probe(*probe_, [this](const ShadowRay& ray) { (*changes_)[ray.pixel].light += luminance(ray.radiance); });
  counts_.shadow +=
      shadow_rays_.trace(scene_, [this](const ShadowRay& ray, Vec3f radiance) { add(ray.pixel, radiance, ray.depth); });
}

/// Emission that a path meets at its second vertex is direct light of the first; what comes later is indirect.
Vec3f PathIntegrator::clamped(Vec3f radiance, int depth) const {
  const float most = largest(radiance);
  return params_.clamp_indirect > 0.0f && depth > 1 && most > params_.clamp_indirect
             ? radiance * (params_.clamp_indirect / most)
             : radiance;
}

}  // namespace lippmann
