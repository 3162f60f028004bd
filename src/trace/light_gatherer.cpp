#include "trace/light_gatherer.hpp"

#include "core/random.hpp"
#include "trace/scene_query.hpp"
#include "transport/sampler.hpp"

namespace lippmann {
namespace {

/// Reflections that are at most 1 / this of the picture are left to chance.
constexpr float kFaint = 8.0f;

/// Shadow rays of a packet are traced as they come where there are so many; fewer wait for others.
constexpr int kNearlyFull = 12;

/// Evenly spread over the samples of a pixel: multiples of the plastic number's powers (M. Roberts, 2018), the steps of the
/// most even sequence of points that is a lattice.
Vec2f jitter(const PathPairs& numbers, int i, int events) {
  const std::uint32_t shift = hash(numbers.seed[i] + static_cast<std::uint32_t>(events)), index = numbers.index[i];
  return {unit_float(shift + index * 3242174889u), unit_float(hash(shift) + index * 2447445414u)};
}

/// Random numbers of the vertex that the ray has met, from one of its pairs on.
PathSampler sampler_at(const PathRay& ray, std::uint32_t pair) {
  PathSampler sampler(ray.seed, ray.index);
  sampler.jump_to(kPairsPerEvent * ray.events + pair);
  return sampler;
}

bool any(const LaneMask& lanes) {
  int any = 0;
  for (const int lane : lanes.lane) any |= lane;
  return any != 0;
}

}  // namespace

LightGatherer::LightGatherer(const DeviceScene::Impl& scene, const LightCells& cells, const LightCache& cache,
                             const PathParams& params, Image& film)
    : scene_(scene),
      cells_(cells),
      cache_(cache),
      params_(params),
      film_(film.data.data()),
      asks_points_alone_(scene.path->lights->points() <= kFewLights &&
                         !(scene.path->lights->chance({LightGroup::kSun, cells.lights_from}) > 0.0f)),
      paths_(scene, cells.beam, params, {film.data.data()}) {}

void LightGatherer::primary(RayHitPacket& packet, const LaneMask& active, const std::uint32_t* pixel,
                            const std::uint32_t* sample, const std::uint32_t* slot) {
  clear_hits(packet);
  intersect_scene(scene_, active, packet, Coherence::kCoherent);
  lanes_.begin();
  const std::uint32_t seed = params_.seed;
  LIPPMANN_FOR_LANES(i) {
    lanes_.pixel[i] = slot[i];
    lanes_.numbers.seed[i] = hash(seed, pixel[i]), lanes_.numbers.index[i] = sample[i];
  }
  for (const int lane : active.lane) counts_.primary += lane != 0;
  shade(packet, active);
}

void LightGatherer::finish_batch() {
  trace_shadow_rays();
  while (!next_.empty()) {
    std::swap(wave_, next_);
    next_.clear();
    trace_wave(scene_, wave_, [this](const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
      for (int i = 0; i < kLanes; ++i)
        if (active.lane[i]) lanes_.set(i, rays[i]);
      shade(packet, active);
    });
    trace_shadow_rays();
  }
  paths_.finish_batch();
}

void LightGatherer::trace_shadow_rays() {
  const auto arrive = [this](const ShadowRay& ray, Vec3f radiance) { add(ray.pixel, radiance); };
  for (ShadowQueue& queue : to_point_) counts_.shadow += queue.trace(scene_, arrive);
  counts_.shadow += to_others_.trace(scene_, arrive);
}

RayCounts LightGatherer::counts() const {
  RayCounts all = counts_;
  lippmann::add(paths_.counts(), all);
  return all;
}

void LightGatherer::shade(const RayHitPacket& packet, const LaneMask& active) {
  Lanes path_length;
  LIPPMANN_FOR_LANES(i) path_length[i] = active.lane[i] != 0 ? lanes_.path_length[i] : 0.0f;
  evaluate_surfaces(scene_, packet, active, path_length, cells_.beam, surface_);
  queries_.active = {};
  const LaneMask phong = phong_lanes();
  if (any(phong)) shade_phong(packet, phong);
  for (int i = 0; i < kLanes; ++i) {
    if (!active.lane[i] || phong.lane[i]) continue;
    const PathRay ray = lanes_.at(packet.ray, i);
    if (surface_.hit.lane[i])
      shade_surface(packet, i, ray);
    else
      shade_sky(packet, i, ray);
  }
  if (any(queries_.active)) add_asked(packet);
}

/// Those that are shaded side by side.
LaneMask LightGatherer::phong_lanes() const {
  LaneMask lanes{};
  if (!asks_points_alone_ || !surface_.any_hit) return lanes;
  for (int i = 0; i < kLanes; ++i)
    if (surface_.hit.lane[i] && scene_.materials.materials[scene_.material_of_instance[surface_.instance[i]]].is_whole)
      lanes.lane[i] = -1;
  return lanes;
}

void LightGatherer::shade_sky(const RayHitPacket& packet, int i, const PathRay& ray) {
  const unsigned id = packet.hit.geomID[i];
  if (id >= kLightId && id != kNoId) {
    if (ray.density == kInfinity) add_seen(ray, ray.throughput * scene_.lights[id - kLightId].color);
    return;
  }
  if (open_ && ray.depth == 0) {
    open_[ray.pixel] += 1.0f;
    return;
  }
  const LightTable& lights = *scene_.path->lights;
  float share = 1.0f;
  if (ray.density != kInfinity) {
    const LightTable::Sky sky = lights.sky(ray.direction);
    share = power_heuristic(ray.density * lights.chance(sky.group), sky.density);
  }
  add_seen(ray, ray.throughput * lights.environment().radiance(ray.direction) * share);
}

void LightGatherer::add_emission(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f emission) {
  float share = 1.0f;
  if (ray.density != kInfinity && surface_.record[i] < kPlaneId) {
    const LightTable& lights = *scene_.path->lights;
    const float distance = ray.path_length + packet.ray.tfar[i] - ray.scattered_at;
    const float of_light = lights.density_of(surface_.record[i], packet.hit.primID[i], distance, ray.direction);
    share = power_heuristic(ray.density * lights.chance(kLamps), of_light);
  }
  add_seen(ray, ray.throughput * emission * share);
}

void LightGatherer::shade_surface(const RayHitPacket& packet, int i, const PathRay& ray) {
  const ShadingPoint point = shading_point(scene_, surface_, i);
  const float length = ray.path_length + packet.ray.tfar[i];
  if (point.coverage < 1.0f) {
    if (!(sampler_at(ray, 3).next().y < point.coverage)) {
      if (ray.events < kMostEvents) next_.push_back(passed(ray, point, length));
      return;
    }
  }
  describe_first(point, i, ray);
  if (point.emission != Vec3f(0.0f)) add_emission(packet, i, ray, point.emission);
  if (!point.scatters || ray.depth + 1 > params_.max_depth) return;
  const Bsdf bsdf = bsdf_at(scene_, packet, surface_, i);
  add_points(point, bsdf, ray);
  const bool has_gloss = bsdf.diffuse_share() < 1.0f;
  const Bsdf gloss = has_gloss ? bsdf.without_diffuse() : bsdf;
  const bool is_rough = has_gloss && !gloss.is_sharp();
  const Vec3f albedo = bsdf.diffuse_albedo();
  add_lights(kSun, point, bsdf, is_rough ? &gloss : nullptr, albedo, ray);
  add_lights(kLamps, point, bsdf, is_rough ? &gloss : nullptr, albedo, ray);
  add_lights(kSkyLight, point, bsdf, is_rough ? &gloss : nullptr, albedo, ray);
  if (albedo != Vec3f(0.0f)) ask(packet, i, bsdf.normal(), albedo, length);
  if (has_gloss) reflect(point, gloss, ray, length);
}

/// What shade_surface() does for one, for Phong's surfaces where all lights that are asked are points.
void LightGatherer::shade_phong(const RayHitPacket& packet, LaneMask lanes) {
  evaluate_phong(surface_, scene_.tachyon, lanes, phong_);
  if (seen_)
    for (int i = 0; i < kLanes; ++i)
      if (lanes.lane[i]) describe_first(shading_point(scene_, surface_, i), i, lanes_.at(packet.ray, i));
  if (phong_.any_emission)
    for (int i = 0; i < kLanes; ++i)
      if (lanes.lane[i] && phong_.emission.get(i) != Vec3f(0.0f))
        add_emission(packet, i, lanes_.at(packet.ray, i), phong_.emission.get(i));
  LIPPMANN_FOR_LANES(i) lanes.lane[i] = lanes_.depth[i] < params_.max_depth ? lanes.lane[i] : 0;
  for (std::size_t l = 0; l < scene_.lights.size(); ++l) light_phong(packet.ray, lanes, l);
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i] && phong_.diffuse.get(i) != Vec3f(0.0f))
      ask(packet, i, surface_.normal.get(i), phong_.diffuse.get(i), lanes_.path_length[i] + packet.ray.tfar[i]);
  if (phong_.any_gloss) reflect_phong(packet, lanes);
}

void LightGatherer::light_phong(const RayPacket& view, const LaneMask& lanes, std::size_t light) {
  const WhittedLight& from = scene_.lights[light];
  aim_at_light(from, surface_, 0.0f, shadow_);
  Lanes3 radiance;
  const Vec3f irradiance = scene_.path->lights->unit() * from.color;
  const int count = reflect_light(surface_, phong_, lanes_, view, irradiance, lanes, shadow_, radiance);
  if (count == 0) return;
  if (count < kNearlyFull) {
    for (int i = 0; i < kLanes; ++i)
      if (shadow_.active.lane[i]) to_point_[light].push(shadow_, i, radiance.get(i), lanes_.pixel[i], lanes_.depth[i] + 1);
    return;
  }
  counts_.shadow += static_cast<std::uint64_t>(count);
  trace_shadows(scene_, shadow_);
  for (int i = 0; i < kLanes; ++i)
    if (shadow_.active.lane[i] && shadow_.rays.tfar[i] >= 0.0f)
      add(lanes_.pixel[i], radiance.get(i) * shadow_.context.transmittance[i]);
}

void LightGatherer::reflect_phong(const RayHitPacket& packet, const LaneMask& lanes) {
  Lanes survival, lobe;
  sample_pairs(lanes_.numbers, 0, survival.lane, lobe.lane);
  GlossyRays rays;
  reflect_gloss(surface_, phong_, lanes_, packet.ray, lanes, lobe, survival, kFaint, rays);
  for (int i = 0; i < kLanes; ++i) {
    if (!rays.active.lane[i]) continue;
    ++counts_.reflection;
    BsdfSample sample;
    sample.direction = rays.direction.get(i), sample.density = kInfinity, sample.straight = rays.straight.lane[i] != 0;
    next_.push_back(scattered(lanes_.at(packet.ray, i), shading_point(scene_, surface_, i), sample, rays.throughput.get(i),
                              lanes_.path_length[i] + packet.ray.tfar[i]));
  }
}

/// For soft light on a diffuse surface: all that ask wait for add_asked().
void LightGatherer::ask(const RayHitPacket& packet, int i, Vec3f normal, Vec3f albedo, float length) {
  const LightPlace place = cells_.places(packet, surface_, i, normal, cells_.size(length));
  queries_.set(i, place, normal, jitter(lanes_.numbers, i, lanes_.events[i]));
  albedo_.set(i, albedo);
}

/// From the cache, and by a path where it knows nothing, and at edges that are left to paths.
void LightGatherer::add_asked(const RayHitPacket& packet) {
  Lanes3 light;
  const LaneMask known = cache_.pick(queries_, edges_, light);
  for (int i = 0; i < kLanes; ++i) {
    if (known.lane[i])
      add_cached(lanes_.pixel[i], lanes_.throughput.get(i) * albedo_.get(i) * light.get(i), queries_.place(i));
    else if (queries_.active.lane[i])
      follow_path(packet, i);
  }
}

void LightGatherer::follow_path(const RayHitPacket& packet, int i) {
  PathRay query = lanes_.at(packet.ray, i);
  PathSampler sampler = sampler_at(query, 0);
  const Vec2f choice = sampler.next(), on_light = sampler.next(), way = sampler.next();
  query.throughput *= albedo_.get(i);
  paths_.gather_diffuse(shading_point(scene_, surface_, i), bsdf_at(scene_, packet, surface_, i), query,
                        query.path_length + packet.ray.tfar[i], cells_.lights_from, {choice.x, on_light, way});
}

void LightGatherer::add_points(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray) {
  const LightTable& lights = *scene_.path->lights;
  if (lights.points() > kFewLights) {
    if (const std::optional<LightSample> light =
            lights.sample(kPointLights, point.position, sampler_at(ray, 0).next().x, Vec2f(0.0f)))
      shine(point, bsdf, *light, ray, to_others_);
    return;
  }
  for (std::size_t l = 0; l < lights.points(); ++l)
    if (const std::optional<LightSample> light = lights.point(l, point.position)) shine(point, bsdf, *light, ray, to_point_[l]);
}

void LightGatherer::shine(const ShadingPoint& point, const Bsdf& bsdf, const LightSample& light, const PathRay& ray,
                          ShadowQueue& queue) {
  const BsdfValue value = bsdf.evaluate(light.direction);
  // Behind the facet there is only what is transmitted, whatever the smooth normal says, and before it only what is not.
  if ((glm::dot(point.facet, light.direction) < 0.0f) != value.transmitted) return;
  const Vec3f radiance = ray.throughput * (value.cosine_f + bsdf.highlight(light.direction)) * light.radiance;
  if (radiance != Vec3f(0.0f) && is_finite(radiance)) queue.push(point, light, radiance, ray.pixel, ray.depth + 1);
}

/// One light of the groups: over rough lobes, and where the cache does not hold it, over the diffuse one, too, which no ray
/// that meets the light comes from.
void LightGatherer::add_lights(LightGroups groups, const ShadingPoint& point, const Bsdf& bsdf, const Bsdf* gloss, Vec3f albedo,
                               const PathRay& ray) {
  const bool is_diffuse = groups.begin < cells_.lights_from && albedo != Vec3f(0.0f);
  const LightTable& lights = *scene_.path->lights;
  if (!(is_diffuse || gloss) || !(lights.chance(groups) > 0.0f)) return;
  PathSampler sampler = sampler_at(ray, 0);
  const float pick = sampler.next().x;
  const std::optional<LightSample> light = lights.sample(groups, point.position, pick, sampler.next());
  if (!light) return;
  const bool behind = glm::dot(point.facet, light->direction) < 0.0f;
  Vec3f weight(0.0f);
  if (is_diffuse && !behind) weight += albedo * bsdf.evaluate_diffuse(light->direction).cosine_f;
  if (gloss) {
    const BsdfValue value = gloss->evaluate(light->direction);
    if (value.density > 0.0f && behind == value.transmitted)
      weight += value.cosine_f * power_heuristic(light->density, value.density);
  }
  const Vec3f radiance = ray.throughput * weight * light->radiance / light->density;
  if (radiance != Vec3f(0.0f) && is_finite(radiance)) to_others_.push(point, *light, radiance, ray.pixel, ray.depth + 1);
}

void LightGatherer::reflect(const ShadingPoint& point, const Bsdf& gloss, const PathRay& ray, float length) {
  const Vec2f choice = sampler_at(ray, 0).next();
  const std::optional<BsdfSample> sample = gloss.sample(choice.y, gloss.is_sharp() ? Vec2f(0.0f) : sampler_at(ray, 2).next());
  if (!sample || (glm::dot(point.facet, sample->direction) < 0.0f) != sample->transmitted) return;
  Vec3f throughput = ray.throughput * sample->weight;
  const float chance = std::min(1.0f, kFaint * largest(throughput));
  if (!(choice.x < chance)) return;
  throughput /= chance;
  if (throughput == Vec3f(0.0f) || !is_finite(throughput)) return;
  ++counts_.reflection;
  next_.push_back(scattered(ray, point, *sample, throughput, length));
}

void LightGatherer::add_cached(std::uint32_t slot, Vec3f radiance, const LightPlace& place) {
  if (!shows_provenance_) return deposit(slot, radiance);
  const float past = cache_.share_of_past(place);
  deposit(slot, luminance(radiance) * Vec3f(0.0f, 1.0f - past, past));
}

/// Light that the ray has met: where it comes straight from the camera, there is no noise of paths in it.
void LightGatherer::add_seen(const PathRay& ray, Vec3f radiance) {
  if (seen_ && ray.depth == 0)
    for (int c = 0; c < 3; ++c) seen_[3 * static_cast<std::size_t>(ray.pixel) + static_cast<std::size_t>(c)] += radiance[c];
  add(ray.pixel, radiance);
}

void LightGatherer::describe_first(const ShadingPoint& point, int i, const PathRay& ray) {
  if (seen_ && ray.depth == 0 && point.scatters) surfaces_.add(point, surface_.normal.get(i), ray.pixel, 1.0f);
}

void LightGatherer::add(std::uint32_t slot, Vec3f radiance) {
  deposit(slot, shows_provenance_ ? Vec3f(luminance(radiance), 0.0f, 0.0f) : radiance);
}

void LightGatherer::deposit(std::uint32_t slot, Vec3f radiance) {
  float* p = film_ + 3 * static_cast<std::size_t>(slot);
  p[0] += radiance.x;
  p[1] += radiance.y;
  p[2] += radiance.z;
}

}  // namespace lippmann
