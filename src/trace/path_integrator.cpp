#include "trace/path_integrator.hpp"

#include <utility>

#include "core/random.hpp"
#include "trace/noisy_frame.hpp"

namespace lippmann {
namespace {

/// Russian roulette starts at this vertex of a path, counted from 1.
constexpr int kRouletteDepth = 3;
constexpr std::uint32_t kColorStream = 0x636f6c6fu;

/// Returns whether a sampled direction is on the correct side of the facet: behind it for transmission, otherwise in front. The
/// shading normal alone may select the wrong side.
bool is_possible(const ShadingPoint& point, Vec3f direction, bool transmitted) {
  return point.is_behind(direction) == transmitted;
}

/// Returns whether a light in `direction` may light the point. Lights just behind the facet are accepted if they are in front
/// of the smooth surface.
bool may_shine(const ShadingPoint& point, Vec3f direction, bool transmitted) {
  return is_possible(point, direction, transmitted) || (!transmitted && point.rises_to(direction));
}

/// Russian roulette: returns false if the path ends, and otherwise divides the throughput by the probability `chance` that it
/// continues.
bool survives(Vec3f& throughput, float chance, float number) {
  if (!(number < chance)) return false;
  throughput /= chance;
  return true;
}

}  // namespace

PathIntegrator::PathIntegrator(const ShadedScene& scene, const BeamFootprint& beam, const PathParams& params,
                               const PathFilm& film)
    : scene_(scene), beam_(beam), params_(params), film_(film), weight_(1.0f / static_cast<float>(params.spp)) {
  if (film.noise) noise_weights_ = weights_of_halves(params.spp);
}

void PathIntegrator::begin(int sample) {
  noise_weight_ = noise_weights_[is_of_second_half(static_cast<std::uint32_t>(sample))];
}

void PathIntegrator::primary(const CameraPacket& packet) {
  alignas(64) std::uint32_t seeds[kLanes];
  const std::uint32_t seed = params_.seed;
  LIPPMANN_FOR_LANES(i) seeds[i] = hash(seed, packet.stream[i]);
  PathRay rays[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    counts_.primary += packet.active.lane[i] != 0;
    rays[i] = camera_path_ray(packet, i, seeds[i]);
  }
  shade(packet.rays, packet.active, rays);
}

void PathIntegrator::finish() {
  trace_shadow_rays();
  while (!next_.empty()) {
    std::swap(wave_, next_);
    next_.clear();
    trace_wave(scene_, wave_,
               [this](const RayHitPacket& packet, const LaneMask& active, PathRay* rays) { shade(packet, active, rays); });
    trace_shadow_rays();
  }
}

void PathIntegrator::shade(const RayHitPacket& packet, LaneMask active, PathRay* rays) {
  if (scene_.has_splats()) meet_splats(packet.ray, active, rays);
  Lanes path_length;
  LaneMask spread;
  for (int i = 0; i < kLanes; ++i) {
    path_length[i] = active.lane[i] ? rays[i].path_length : 0.0f;
    spread.lane[i] = active.lane[i] && rays[i].spread ? -1 : 0;
  }
  evaluate_surfaces(scene_, packet, active, path_length, beam_, surface_, &spread);
  if (surface_.any_miss) look_up_sky(packet.ray);
  meet_round_lights(packet, active, rays);
  if (surface_.any_hit) draw_numbers(rays);
  vertices_.active = {};
  for (int i = 0; i < kLanes; ++i) {
    if (!active.lane[i]) continue;
    if (surface_.hit.lane[i])
      shade_surface(packet, i, rays[i]);
    else
      shade_miss(packet, i, rays[i]);
  }
  if (any(vertices_.active)) scatter(packet, rays);
}

void PathIntegrator::draw_numbers(const PathRay* rays) {
  bool with_roulette = false;
  for (int i = 0; i < kLanes; ++i) with_roulette |= surface_.hit.lane[i] && rays[i].depth + 1 >= kRouletteDepth;
  numbers_.draw(surface_.hit, rays, with_roulette || surface_.any_see_through);
}

void PathIntegrator::shade_surface(const RayHitPacket& packet, int i, PathRay& ray) {
  ShadingPoint& point = vertices_.points[static_cast<std::size_t>(i)];
  point = shading_point(scene_, surface_, i);
  const float length = ray.path_length + packet.ray.tfar[i];
  if (!(point.coverage >= 1.0f) && !(numbers_.pair(i, kCoveragePair).y < point.coverage)) {
    if (ray.events < kMostEvents) next_.push_back(passed(ray, point, length));
    return;
  }
  if (film_.surfaces && ray.has_met_nothing() && point.scatters)
    film_.surfaces->add(point, surface_.normal.get(i), ray.pixel, weight_ * ray.throughput.x);
  if (point.emission != Vec3f(0.0f)) meet_emission(packet, i, ray, point.emission);
  if (!point.scatters) return;
  if (ray.depth + 1 > params_.max_depth) return pass_wall(packet, i, ray, length);
  if (point.disperses) make_one_color(ray, i);
  vertices_.lengths[i] = length;
  vertices_.active.lane[i] = -1;
}

/// Continues a path at the maximum depth straight through a thin wall, because shadow rays pass thin walls too.
void PathIntegrator::pass_wall(const RayHitPacket& packet, int i, const PathRay& ray, float length) {
  const ShadingPoint& point = vertices_.point(i);
  if (!point.is_wall) return;
  BsdfSample on;
  on.direction = ray.direction, on.density = kInfinity;
  on.transmitted = on.straight = true, on.is_vertex = false;
  const Vec3f straight = bsdf_at(scene_, packet, surface_, i).straight();
  send_on(ray, point, on, ray.throughput * straight, length);
}

/// Restricts a path to one random colour channel, with three times the throughput, where a surface disperses light.
void PathIntegrator::make_one_color(PathRay& ray, int i) {
  const std::uint32_t channel = hash(ray.seed, ray.index, kColorStream) % 3;
  surface_.color_channel[i] = static_cast<std::uint8_t>(channel);
  if (ray.one_color) return;
  Vec3f throughput(0.0f);
  throughput[static_cast<int>(channel)] = 3.0f * ray.throughput[static_cast<int>(channel)];
  ray.throughput = throughput;
  ray.one_color = true;
}

void PathIntegrator::scatter(const RayHitPacket& packet, const PathRay* rays) {
  const LaneMask& lanes = vertices_.active;
  vertices_.bsdfs.clear();
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i]) vertices_.bsdfs.set(scene_, packet, surface_, i);
  vertices_.bsdfs.prepare();
  sample_lights(rays);
  const auto &choice = numbers_.pairs(kChoicePair), &way = numbers_.pairs(kWayPair);
  BsdfSamples samples;
  vertices_.bsdfs.sample(lanes, choice.y, way.x, way.y, samples);
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i])
      if (const std::optional<BsdfSample> sample = samples.get(i)) follow(i, rays[i], *sample);
}

void PathIntegrator::sample_lights(const PathRay* rays) {
  std::array<LightSample, kLanes> samples;
  Lanes3 directions{};
  LaneMask lit{};
  for (int i = 0; i < kLanes; ++i) {
    if (!vertices_.active.lane[i]) continue;
    const std::optional<LightSample> light = light_for(i);
    if (!light) continue;
    samples[static_cast<std::size_t>(i)] = *light;
    directions.set(i, light->direction);
    lit.lane[i] = -1;
  }
  if (!any(lit)) return;
  BsdfValueLanes values;
  vertices_.bsdfs.evaluate(lit, directions, values);
  for (int i = 0; i < kLanes; ++i)
    if (lit.lane[i]) shine(i, samples[static_cast<std::size_t>(i)], values.get(i), rays[i]);
}

std::optional<LightSample> PathIntegrator::light_for(int i) {
  const float pick = numbers_.pair(i, kChoicePair).x;
  LightReceiver at;
  if (lights().choice().has_both_kinds()) {
    at = vertices_.receiver(i);
    vertices_.near_share[i] = at.near_share = lights().choice().near_share(at);
  }
  if (lights().choice().asks_sky_often() && lights().choice().picks_sky(at, pick))
    return lights().sky_sample(numbers_.sky_draws(lights().environment()), i, at);
  if (!lights().choice().has_both_kinds()) at = vertices_.receiver(i);
  return lights().sample(at, pick, numbers_.pair(i, kOnLightPair));
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

/// Weights the light of an area light by multiple importance sampling. If the light is behind the facet, only the diffuse
/// reflection counts, with full weight, because the BSDF never samples this direction.
Vec3f PathIntegrator::from_wide_light(int i, const LightSample& light, const BsdfValue& value) const {
  const Vec3f per_density = light.radiance / light.density;
  Vec3f f = value.cosine_f * power_heuristic(light.density, value.density);
  if (vertices_.point(i).rises_to(light.direction))
    f = vertices_.bsdfs.diffuse_albedo(i) * vertices_.bsdfs.evaluate_diffuse(i, light.direction);
  if (light.is_lamp) f += vertices_.bsdfs.highlight(i, light.direction);
  return f * per_density;
}

void PathIntegrator::follow(int i, const PathRay& ray, const BsdfSample& sample) {
  const ShadingPoint& point = vertices_.point(i);
  if (!is_possible(point, sample.direction, sample.transmitted)) return;
  Vec3f throughput = ray.throughput * sample.weight;
  if (ray.depth + 1 >= kRouletteDepth &&
      !survives(throughput, std::min(0.95f, largest(throughput)), numbers_.pair(i, kCoveragePair).x))
    return;
  PathRay* const next = send_on(ray, point, sample, throughput, vertices_.lengths[i]);
  if (!next || sample.straight) return;
  next->lit_side = vertices_.bsdfs.lit_side(i, point.normal), next->near_share = vertices_.near_share[i];
}

/// Queues the next ray of a path. Returns null if the path ends. The pointer is valid until the next call.
PathRay* PathIntegrator::send_on(const PathRay& ray, const ShadingPoint& point, const BsdfSample& sample, Vec3f throughput,
                                 float length) {
  if (throughput == Vec3f(0.0f) || !is_finite(throughput)) return nullptr;
  if (!sample.is_vertex && ray.events >= kMostEvents) return nullptr;
  ++(sample.is_delta() ? counts_.reflection : counts_.indirect);
  PathRay& next = next_.emplace_back(ray);
  lippmann::scatter(next, point, sample, throughput, length);
  return &next;
}

void PathIntegrator::trace_shadow_rays() {
  counts_.shadow +=
      shadow_rays_.trace(scene_, [this](const ShadowRay& ray, Vec3f radiance) { add(ray.pixel, radiance, ray.depth); });
}

/// Clamps indirect light, which more than one vertex has scattered (depth > 1).
Vec3f PathIntegrator::clamped(Vec3f radiance, int depth) const {
  const float most = largest(radiance);
  return params_.clamp_indirect > 0.0f && depth > 1 && most > params_.clamp_indirect
             ? radiance * (params_.clamp_indirect / most)
             : radiance;
}

void PathIntegrator::add(std::uint32_t pixel, Vec3f radiance, int depth) {
  const auto add_to = [&](float* film, float weight) {
    float* p = film + 3 * static_cast<std::size_t>(pixel);
    for (int c = 0; c < 3; ++c) p[c] += weight * radiance[c];
  };
  add_to(film_.all, weight_);
  if (float* part = depth > 1 ? film_.indirect : film_.direct) add_to(part, weight_);
  if (film_.seen && depth == 0) add_to(film_.seen, weight_);
  if (film_.noise) add_to(film_.noise, weight_ * noise_weight_);
}

constinit const IntegratorModel path_model{
    {.name = "path",
     .default_samples = 16,
     .is_stochastic = true,
     .separates_light = true,
     .samples_all_light = true,
     .is_lit_by_surroundings = true},
    [](const Integration& from) -> std::unique_ptr<FrameIntegrator> {
      const TraceParams& trace = from.params;
      const PathParams params{trace.max_depth, hash(trace.seed, trace.frame), trace.clamp_indirect, trace.spp};
      return std::make_unique<PathIntegrator>(from.scene, from.beam, params, from.film);
    }};

}  // namespace lippmann
