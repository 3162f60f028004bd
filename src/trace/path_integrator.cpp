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

void PathIntegrator::vertex(const RayHitPacket& packet, int i, const PathRay& ray, const ShadingPoint& point, float length) {
  const Bsdf bsdf = bsdf_at(scene_, packet, surface_, i);
  const Vec2f choice = numbers(ray, i, kChoicePair);
  aim_at_light(point, bsdf, ray, i);
  const std::optional<BsdfSample> sample = bsdf.sample(choice.y, numbers(ray, i, kWayPair));
  if (!sample || !is_possible(point, sample->direction, sample->transmitted)) return;
  Vec3f throughput = ray.throughput * sample->weight;
  if (ray.depth + 1 >= kRouletteDepth &&
      !survives(throughput, std::min(0.95f, largest(throughput)), numbers(ray, i, kCoveragePair).x))
    return;
  go_on(ray, point, bsdf.lit_side(point.normal), *sample, throughput, length,
        sample->is_delta() ? counts_.reflection : counts_.indirect);
}

void PathIntegrator::aim_at_light(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray, int i) {
  const float pick = numbers(ray, i, kChoicePair).x;
  const std::optional<LightSample> light =
      lights().asks_sky_often() && lights().picks_sky(pick)
          ? LightTable::sky_sample(sky_draws(), i, lights().chance(kSkyLight))
          : lights().sample({point.position, bsdf.lit_side(point.normal)}, pick, numbers(ray, i, kOnLightPair));
  if (light) aim_at(*light, point, bsdf, ray);
}

void PathIntegrator::aim_at(const LightSample& light, const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray) {
  const BsdfValue value = bsdf.evaluate(light.direction);
  if (!may_shine(point, light.direction, value.transmitted)) return;
  Vec3f radiance = light.is_point() ? (value.cosine_f + bsdf.highlight(light.direction)) * light.radiance
                                    : from_wide_light(point, bsdf, light, value);
  radiance *= ray.throughput;
  if (radiance == Vec3f(0.0f) || !is_finite(radiance)) return;
  shadow_rays_.push(point, light, clamped(radiance, ray.depth + 1), ray.pixel, ray.depth + 1);
}

/// No path goes behind the facet by itself. There light is asked for alone, which is too noisy for gloss.
Vec3f PathIntegrator::from_wide_light(const ShadingPoint& point, const Bsdf& bsdf, const LightSample& light,
                                      const BsdfValue& value) {
  const Vec3f per_density = light.radiance / light.density;
  Vec3f f = value.cosine_f * power_heuristic(light.density, value.density);
  if (point.rises_to(light.direction)) f = bsdf.diffuse_albedo() * bsdf.evaluate_diffuse(light.direction).cosine_f;
  if (light.is_lamp) f += bsdf.highlight(light.direction);
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
