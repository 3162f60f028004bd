#include "radiance/final_gather.hpp"

namespace lippmann {
namespace {

/// Evenly spread over the samples of a pixel: multiples of the plastic number's powers (M. Roberts, 2018), the steps of the
/// most even sequence of points that is a lattice.
Vec2f jitter(const PathRay& ray) {
  const std::uint32_t shift = hash(ray.seed + ray.events), index = ray.index;
  return {unit_float(shift + index * 3242174889u), unit_float(hash(shift) + index * 2447445414u)};
}

}  // namespace

FinalGather::FinalGather(const ShadedScene& scene, const CacheCells& cells, const RadianceCache& cache,
                         const PathParams& params, const PathFilm& film, const FinalGatherOptions& options)
    : PathTracer(scene, cells.beam, params, film),
      cells_(cells),
      cache_(cache),
      options_(options),
      samples_points_alone_(lights().points() <= kFewLights && !lights().has({LightGroup::kRound, cells.lights_from})),
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
void FinalGather::end_packet(const RayHitPacket& packet, const PathRay* rays) {
  if (!any(queries_.active)) return;
  Lanes3 light;
  const LaneMask known = cache_.pick(queries_, options_.edges, options_.light, light);
  LaneMask left{};
  for (int i = 0; i < kLanes; ++i) {
    if (known.lane[i])
      add_cached(rays[i], rays[i].throughput * albedo_.get(i) * light.get(i), queries_.place(i));
    else
      left.lane[i] = queries_.active.lane[i];
  }
  if (any(left)) follow_paths(packet, left, rays);
}

void FinalGather::scatter(const RayHitPacket& packet, const PathRay* rays) {
  make_bsdfs(packet);
  const LaneMask& lanes = vertices_.active;
  BsdfPacket& bsdfs = vertices_.bsdfs;
  add_points(rays);
  LaneMask glossy{};
  for (int i = 0; i < kLanes; ++i) {
    if (!lanes.lane[i]) continue;
    albedo_.set(i, bsdfs.diffuse_albedo(i));
    glossy.lane[i] = bsdfs.diffuse_share(i) < 1.0f ? -1 : 0;
  }
  bsdfs.remove_diffuse();
  for (int i = 0; i < kLanes; ++i) rough_.lane[i] = glossy.lane[i] && !bsdfs.is_sharp(i) ? -1 : 0;
  add_rounds(rays);
  for (const LightGroups groups : {kSun, kLamps, kSkyLight}) add_lights(groups, rays);
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i] && albedo_.get(i) != Vec3f(0.0f))
      ask_cache(packet, i, rays[i], bsdfs.normal(i), albedo_.get(i), vertices_.lengths[i]);
  if (any(glossy)) reflect(glossy, rays);
}

/// For soft light on a diffuse surface: all that ask wait for end_packet().
void FinalGather::ask_cache(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f normal, Vec3f albedo, float length) {
  const CachePoint place = cells_.places(packet, surface_, i, normal, cells_.size(length));
  queries_.set(i, place, normal, jitter(ray));
  albedo_.set(i, albedo);
}

void FinalGather::follow_paths(const RayHitPacket& packet, const LaneMask& lanes, const PathRay* rays) {
  whole_.clear();
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i]) whole_.set(scene_, packet, surface_, i);
  whole_.prepare();
  for (int i = 0; i < kLanes; ++i) {
    if (!lanes.lane[i]) continue;
    const PathRay& ray = rays[i];
    PathRay query = ray;
    query.throughput *= albedo_.get(i);
    if (options_.paths) options_.paths[ray.pixel] += 1.0f;
    const ShadingPoint point = shading_point(scene_, surface_, i);
    const std::optional<LightSample> light =
        lights().sample({cells_.lights_from, LightGroup::kEnd}, {point.position, whole_.normal(i)}, draw(ray, kChoicePair).x,
                        draw(ray, kOnLightPair));
    paths_.gather_diffuse({point, whole_, i, ray.path_length + packet.ray.tfar[i]}, query, cells_.lights_from, light,
                          draw(ray, kWayPair));
  }
}

void FinalGather::add_points(const PathRay* rays) {
  const auto shine_into = [&](ShadowQueue& queue) {
    return [&](int i, const LightSample& light, const BsdfValue& value) { shine(i, light, value, rays[i], queue); };
  };
  if (lights().points() > kFewLights) {
    const auto one_of_them = [&](int i) {
      return lights().sample(kPointLights, vertices_.receiver(i), numbers(rays[i], i, kChoicePair).x, Vec2f(0.0f));
    };
    return ask_lights(vertices_.active, one_of_them, shine_into(to_others_));
  }
  for (std::size_t l = 0; l < lights().points(); ++l)
    ask_lights(
        vertices_.active, [&](int i) { return lights().point(l, vertices_.point(i).position); }, shine_into(to_point_[l]));
}

void FinalGather::shine(int i, const LightSample& light, const BsdfValue& value, const PathRay& ray, ShadowQueue& queue) {
  const ShadingPoint& point = vertices_.point(i);
  if (!may_shine(point, light.direction, value.transmitted)) return;
  const Vec3f radiance = ray.throughput * (value.cosine_f + vertices_.bsdfs.highlight(i, light.direction)) * light.radiance;
  if (radiance != Vec3f(0.0f) && is_finite(radiance)) queue.push(point, light, radiance, ray.pixel, ray.depth + 1);
}

/// One light of the groups: over rough lobes, and where the cache does not hold it, over the diffuse one, too, which no ray
/// that meets the light comes from.
void FinalGather::add_lights(LightGroups groups, const PathRay* rays) {
  if (!lights().has(groups)) return;
  const bool over_diffuse = groups.begin < cells_.lights_from;
  ask_lights(
      rough_,
      [&](int i) -> std::optional<LightSample> {
        if (!(over_diffuse && albedo_.get(i) != Vec3f(0.0f)) && !rough_.lane[i]) return std::nullopt;
        if (groups.begin == LightGroup::kSky) return LightTable::sky_sample(sky_draws(), i, 1.0f);
        return lights().sample(groups, vertices_.receiver(i), numbers(rays[i], i, kChoicePair).x,
                               numbers(rays[i], i, kOnLightPair));
      },
      [&](int i, const LightSample& light, const BsdfValue& value) { add_light(i, light, value, over_diffuse, rays[i]); });
}

/// Lamps that have a size: the cache never holds them.
void FinalGather::add_rounds(const PathRay* rays) {
  if (!asks_all_rounds()) return add_lights(kRoundLights, rays);
  for (std::size_t k = 0; k < lights().rounds(); ++k)
    ask_lights(
        rough_, [&](int i) { return lights().round(k, vertices_.point(i).position, numbers(rays[i], i, kOnLightPair)); },
        [&](int i, const LightSample& light, const BsdfValue& value) { add_light(i, light, value, true, rays[i]); });
}

void FinalGather::add_light(int i, const LightSample& light, const BsdfValue& value, bool over_diffuse, const PathRay& ray) {
  const ShadingPoint& point = vertices_.point(i);
  const BsdfPacket& bsdfs = vertices_.bsdfs;
  const bool rises = point.rises_to(light.direction), behind = point.is_behind(light.direction) && !rises;
  Vec3f weight(0.0f);
  if (over_diffuse && !behind && albedo_.get(i) != Vec3f(0.0f))
    weight += albedo_.get(i) * bsdfs.evaluate_diffuse(i, light.direction).cosine_f;
  if (light.is_lamp && !behind) weight += bsdfs.highlight(i, light.direction);
  if (rough_.lane[i] && !rises && value.density > 0.0f && behind == value.transmitted)
    weight += value.cosine_f * power_heuristic(light.density, value.density);
  const Vec3f radiance = ray.throughput * weight * light.radiance / light.density;
  if (radiance != Vec3f(0.0f) && is_finite(radiance)) to_others_.push(point, light, radiance, ray.pixel, ray.depth + 1);
}

void FinalGather::reflect(const LaneMask& lanes, const PathRay* rays) {
  BsdfSamples samples;
  vertices_.bsdfs.sample(lanes, numbers(kChoicePair).y, numbers(kWayPair).x, numbers(kWayPair).y, samples);
  for (int i = 0; i < kLanes; ++i) {
    if (!lanes.lane[i]) continue;
    const ShadingPoint& point = vertices_.point(i);
    const std::optional<BsdfSample> sample = samples.get(i);
    if (!sample || !is_possible(point, sample->direction, sample->transmitted)) continue;
    Vec3f throughput = rays[i].throughput * sample->weight;
    if (survives(throughput, std::min(1.0f, kFaint * largest(throughput)), numbers(rays[i], i, kChoicePair).x))
      go_on(rays[i], point, vertices_.bsdfs.lit_side(i, point.normal), *sample, throughput, vertices_.lengths[i],
            counts_.reflection);
  }
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
