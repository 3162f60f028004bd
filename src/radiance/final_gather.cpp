#include "radiance/final_gather.hpp"

namespace lippmann {
namespace {

/// Evenly spread over the samples of a pixel: multiples of the plastic number's powers (M. Roberts, 2018), the steps of the
/// most even sequence of points that is a lattice.
Vec2f jitter(const PathRay& ray) {
  const std::uint32_t shift = hash(ray.seed + ray.events), index = ray.index;
  return {unit_float(shift + index * 3242174889u), unit_float(hash(shift) + index * 2447445414u)};
}

bool any(const LaneMask& lanes) {
  int any = 0;
  for (const int lane : lanes.lane) any |= lane;
  return any != 0;
}

}  // namespace

FinalGather::FinalGather(const ShadedScene& scene, const CacheCells& cells, const RadianceCache& cache,
                         const PathParams& params, const PathFilm& film, const FinalGatherOptions& options)
    : PathTracer(scene, cells.beam, params, film),
      cells_(cells),
      cache_(cache),
      options_(options),
      samples_points_alone_(lights().points() <= kFewLights &&
                            !(lights().chance({LightGroup::kRound, cells.lights_from}) > 0.0f)),
      paths_(scene, cells.beam, params, {.all = film.all}) {}

void FinalGather::finish() {
  PathTracer::finish();
  paths_.finish();
}

RayCounts FinalGather::counts() const {
  RayCounts all = counts_;
  lippmann::add(paths_.counts(), all);
  return all;
}

void FinalGather::trace_shadow_rays() {
  const auto arrive = [this](const ShadowRay& ray, Vec3f radiance) { add_traced(ray.pixel, radiance, ray.depth); };
  for (ShadowQueue& queue : to_point_) counts_.shadow += queue.trace(scene_, arrive);
  counts_.shadow += to_others_.trace(scene_, arrive);
}

LaneMask FinalGather::begin_packet(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
  queries_.active = {};
  const LaneMask phong = phong_lanes();
  LaneMask left = active;
  if (any(phong)) {
    shade_phong(packet, phong, rays);
    LIPPMANN_FOR_LANES(i) left.lane[i] &= ~phong.lane[i];
  }
  LaneMask surfaces;
  LIPPMANN_FOR_LANES(i) surfaces.lane[i] = left.lane[i] & surface_.hit.lane[i];
  if (any(surfaces)) draw_numbers(rays, surface_.any_see_through);
  return left;
}

/// What was asked of the cache: from there, and by a path where it knows nothing, and at edges that are left to paths.
void FinalGather::end_packet(const RayHitPacket& packet, const LaneMask&, const PathRay* rays) {
  if (!any(queries_.active)) return;
  Lanes3 light;
  const LaneMask known = cache_.pick(queries_, options_.edges, light);
  for (int i = 0; i < kLanes; ++i) {
    if (known.lane[i])
      add_cached(rays[i], rays[i].throughput * albedo_.get(i) * light.get(i), queries_.place(i));
    else if (queries_.active.lane[i])
      follow_path(packet, i, rays[i]);
  }
}

void FinalGather::vertex(const RayHitPacket& packet, int i, const PathRay& ray, const ShadingPoint& point, float length) {
  Bsdf bsdf = bsdf_at(scene_, packet, surface_, i);
  const Vec2f choice = numbers(ray, i, kChoicePair);
  add_points(point, bsdf, ray, choice.x);
  const Vec3f albedo = bsdf.diffuse_albedo();
  const bool has_gloss = bsdf.diffuse_share() < 1.0f;
  if (has_gloss) bsdf.remove_diffuse();
  const Asking asking{point, bsdf, has_gloss && !bsdf.is_sharp(), albedo, ray, i, choice.x, numbers(ray, i, kOnLightPair)};
  add_rounds(asking);
  for (const LightGroups groups : {kSun, kLamps, kSkyLight}) add_lights(groups, asking);
  if (albedo != Vec3f(0.0f)) ask_cache(packet, i, ray, bsdf.normal(), albedo, length);
  if (has_gloss) reflect(point, bsdf, bsdf.lit_side(point.normal), ray, length, {choice, numbers(ray, i, kWayPair)});
}

/// For soft light on a diffuse surface: all that ask wait for end_packet().
void FinalGather::ask_cache(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f normal, Vec3f albedo, float length) {
  const CachePoint place = cells_.places(packet, surface_, i, normal, cells_.size(length));
  queries_.set(i, place, normal, jitter(ray));
  albedo_.set(i, albedo);
}

void FinalGather::follow_path(const RayHitPacket& packet, int i, const PathRay& ray) {
  PathRay query = ray;
  query.throughput *= albedo_.get(i);
  if (options_.paths) options_.paths[ray.pixel] += 1.0f;
  paths_.gather_diffuse(shading_point(scene_, surface_, i), bsdf_at(scene_, packet, surface_, i), query,
                        ray.path_length + packet.ray.tfar[i], cells_.lights_from,
                        {draw(ray, kChoicePair).x, draw(ray, kOnLightPair), draw(ray, kWayPair)});
}

void FinalGather::add_points(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray, float pick) {
  if (lights().points() > kFewLights) {
    if (const std::optional<LightSample> light =
            lights().sample(kPointLights, {point.position, bsdf.lit_side(point.normal)}, pick, Vec2f(0.0f)))
      shine(point, bsdf, *light, ray, to_others_);
    return;
  }
  for (std::size_t l = 0; l < lights().points(); ++l)
    if (const std::optional<LightSample> light = lights().point(l, point.position))
      shine(point, bsdf, *light, ray, to_point_[l]);
}

void FinalGather::shine(const ShadingPoint& point, const Bsdf& bsdf, const LightSample& light, const PathRay& ray,
                        ShadowQueue& queue) {
  const BsdfValue value = bsdf.evaluate(light.direction);
  if (!may_shine(point, light.direction, value.transmitted)) return;
  const Vec3f radiance = ray.throughput * (value.cosine_f + bsdf.highlight(light.direction)) * light.radiance;
  if (radiance != Vec3f(0.0f) && is_finite(radiance)) queue.push(point, light, radiance, ray.pixel, ray.depth + 1);
}

/// One light of the groups: over rough lobes, and where the cache does not hold it, over the diffuse one, too, which no ray
/// that meets the light comes from.
void FinalGather::add_lights(LightGroups groups, const Asking& asking) {
  const bool is_diffuse = groups.begin < cells_.lights_from && asking.albedo != Vec3f(0.0f);
  if (!(is_diffuse || asking.is_rough) || !(lights().chance(groups) > 0.0f)) return;
  if (const std::optional<LightSample> light = groups.begin == LightGroup::kSky
                                                   ? LightTable::sky_sample(sky_draws(), asking.lane, 1.0f)
                                                   : lights().sample(groups, asking.receiver(), asking.pick, asking.on_light))
    add_light(*light, is_diffuse, asking);
}

/// Lamps that have a size: the cache never holds them.
void FinalGather::add_rounds(const Asking& asking) {
  if (!asks_all_rounds()) return add_lights(kRoundLights, asking);
  if (lights().rounds() == 0) return;
  for (std::size_t k = 0; k < lights().rounds(); ++k)
    if (const std::optional<LightSample> light = lights().round(k, asking.point.position, asking.on_light))
      add_light(*light, asking.albedo != Vec3f(0.0f), asking);
}

void FinalGather::add_light(const LightSample& light, bool is_diffuse, const Asking& asking) {
  const ShadingPoint& point = asking.point;
  const bool rises = point.rises_to(light.direction), behind = point.is_behind(light.direction) && !rises;
  Vec3f weight(0.0f);
  if (is_diffuse && !behind) weight += asking.albedo * asking.bsdf.evaluate_diffuse(light.direction).cosine_f;
  if (light.is_lamp && !behind) weight += asking.bsdf.highlight(light.direction);
  if (asking.is_rough && !rises) {
    const BsdfValue value = asking.bsdf.evaluate(light.direction);
    if (value.density > 0.0f && behind == value.transmitted)
      weight += value.cosine_f * power_heuristic(light.density, value.density);
  }
  const PathRay& ray = asking.ray;
  const Vec3f radiance = ray.throughput * weight * light.radiance / light.density;
  if (radiance != Vec3f(0.0f) && is_finite(radiance)) to_others_.push(point, light, radiance, ray.pixel, ray.depth + 1);
}

void FinalGather::reflect(const ShadingPoint& point, const Bsdf& gloss, Vec3f lit_side, const PathRay& ray, float length,
                          const Numbers& drawn) {
  const std::optional<BsdfSample> sample = gloss.sample(drawn.choice.y, gloss.is_sharp() ? Vec2f(0.0f) : drawn.way);
  if (!sample || !is_possible(point, sample->direction, sample->transmitted)) return;
  Vec3f throughput = ray.throughput * sample->weight;
  if (survives(throughput, std::min(1.0f, kFaint * largest(throughput)), drawn.choice.x))
    go_on(ray, point, lit_side, *sample, throughput, length, counts_.reflection);
}

void FinalGather::add_cached(const PathRay& ray, Vec3f radiance, const CachePoint& place) {
  const float past = options_.provenance || options_.looked_up ? cache_.share_of_past(place) : 0.0f;
  if (options_.looked_up) options_.looked_up[ray.pixel] += luminance(radiance) * Vec2f(1.0f - past, past);
  if (!options_.provenance) return add(ray.pixel, radiance, ray.depth + 1);
  add(ray.pixel, luminance(radiance) * Vec3f(0.0f, 1.0f - past, past), ray.depth + 1);
}

void FinalGather::add_traced(std::uint32_t slot, Vec3f radiance, int depth) {
  add(slot, options_.provenance ? Vec3f(luminance(radiance), 0.0f, 0.0f) : radiance, depth);
}

}  // namespace lippmann
