#include "trace/light_gatherer.hpp"

#include "core/random.hpp"
#include "trace/scene_query.hpp"
#include "transport/sampler.hpp"

namespace lippmann {
namespace {

/// Reflections that are at most 1 / this of the picture are left to chance.
constexpr float kFaint = 8.0f;

/// Evenly spread over the samples of a pixel: multiples of the plastic number's powers (M. Roberts, 2018), the steps of the
/// most even sequence of points that is a lattice.
Vec2f jitter(const PathRay& ray) {
  const std::uint32_t shift = hash(ray.seed + ray.events), index = ray.index;
  return {unit_float(shift + index * 3242174889u), unit_float(hash(shift) + index * 2447445414u)};
}

}  // namespace

LightGatherer::LightGatherer(const DeviceScene::Impl& scene, const LightCells& cells, const LightCache& cache,
                             const PathParams& params, Image& film)
    : scene_(scene),
      cells_(cells),
      cache_(cache),
      params_(params),
      film_(film.data.data()),
      paths_(scene, cells.beam, params, {film.data.data()}) {}

void LightGatherer::primary(RayHitPacket& packet, const LaneMask& active, const std::uint32_t* pixel,
                            const std::uint32_t* sample, const std::uint32_t* slot) {
  clear_hits(packet);
  intersect_scene(scene_, active, packet, Coherence::kCoherent);
  PathRay rays[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    if (!active.lane[i]) continue;
    ++counts_.primary;
    rays[i] = primary_path_ray(packet, i, slot[i]);
    rays[i].seed = hash(params_.seed, pixel[i]), rays[i].index = sample[i];
  }
  shade(packet, active, rays);
}

void LightGatherer::finish_batch() {
  trace_shadow_rays();
  while (!next_.empty()) {
    std::swap(wave_, next_);
    next_.clear();
    trace_wave(scene_, wave_, [this](const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
      shade(packet, active, rays);
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

void LightGatherer::shade(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
  Lanes path_length;
  for (int i = 0; i < kLanes; ++i) path_length[i] = active.lane[i] ? rays[i].path_length : 0.0f;
  evaluate_surfaces(scene_, packet, active, path_length, cells_.beam, surface_);
  for (int i = 0; i < kLanes; ++i) {
    if (!active.lane[i]) continue;
    if (surface_.hit.lane[i])
      shade_surface(packet, i, rays[i]);
    else
      shade_sky(packet, i, rays[i]);
  }
}

void LightGatherer::shade_sky(const RayHitPacket& packet, int i, const PathRay& ray) {
  const unsigned id = packet.hit.geomID[i];
  if (id >= kLightId && id != kNoId) {
    if (ray.density == kInfinity) add(ray.pixel, ray.throughput * scene_.lights[id - kLightId].color);
    return;
  }
  const LightTable& lights = *scene_.path->lights;
  const float share = ray.density == kInfinity
                          ? 1.0f
                          : power_heuristic(ray.density * lights.soft_chance(), lights.density_of_sky(ray.direction));
  add(ray.pixel, ray.throughput * lights.environment().radiance(ray.direction) * share);
}

void LightGatherer::add_emission(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f emission) {
  float share = 1.0f;
  if (ray.density != kInfinity && surface_.record[i] < kPlaneId) {
    const LightTable& lights = *scene_.path->lights;
    const float distance = ray.path_length + packet.ray.tfar[i] - ray.scattered_at;
    const float of_light = lights.density_of(surface_.record[i], packet.hit.primID[i], distance, ray.direction);
    share = power_heuristic(ray.density * lights.soft_chance(), of_light);
  }
  add(ray.pixel, ray.throughput * emission * share);
}

void LightGatherer::shade_surface(const RayHitPacket& packet, int i, const PathRay& ray) {
  const ShadingPoint point = shading_point(scene_, packet, surface_, i);
  PathSampler sampler(ray.seed, ray.index);
  sampler.jump_to(kPairsPerEvent * ray.events);
  const float length = ray.path_length + packet.ray.tfar[i];
  if (point.coverage < 1.0f) {
    PathSampler chance = sampler;
    chance.jump_to(kPairsPerEvent * ray.events + 3);
    if (!(chance.next().y < point.coverage)) {
      if (ray.events < kMostEvents) next_.push_back(passed(ray, point, length));
      return;
    }
  }
  if (point.emission != Vec3f(0.0f)) add_emission(packet, i, ray, point.emission);
  if (!point.scatters || ray.depth + 1 > params_.max_depth) return;
  const Bsdf bsdf = bsdf_at(scene_, packet, surface_, i);
  const Vec3f albedo = bsdf.diffuse_albedo();
  add_points(point, bsdf, ray, sampler);
  if (albedo != Vec3f(0.0f)) {
    Vec3f normal = bsdf.normal();
    const LightPlace place = cells_.places(packet, surface_, i, normal, cells_.size(length));
    const Vec4f light = cache_.pick(place, normal, jitter(ray));
    if (light.w > 0.0f) {
      add_cached(ray.pixel, ray.throughput * albedo * Vec3f(light), place);
    } else {
      PathRay query = ray;
      query.throughput *= albedo;
      const Vec2f choice = sampler.next(), on_light = sampler.next(), way = sampler.next();
      paths_.gather_soft_light(point, bsdf, query, length, {choice.x, on_light, way});
    }
  }
  if (bsdf.diffuse_share() >= 1.0f) return;
  const Bsdf gloss = bsdf.without_diffuse();
  sampler.jump_to(kPairsPerEvent * ray.events);
  const Vec2f choice = sampler.next();
  Vec2f way(0.0f);
  if (!gloss.is_sharp()) {
    const Vec2f on_light = sampler.next();
    way = sampler.next();
    add_soft_gloss(point, gloss, ray, choice.x, on_light);
  }
  reflect(point, gloss, ray, length, choice, way);
}

void LightGatherer::add_points(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray, PathSampler& sampler) {
  const LightTable& lights = *scene_.path->lights;
  if (lights.points() > kFewLights) {
    if (const std::optional<LightSample> light = lights.sample_points(point.position, sampler.next().x))
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

/// What sky and lamps with area send over the lobes that are not diffuse.
void LightGatherer::add_soft_gloss(const ShadingPoint& point, const Bsdf& gloss, const PathRay& ray, float pick, Vec2f u) {
  const std::optional<LightSample> light = scene_.path->lights->sample_soft(point.position, pick, u);
  if (!light) return;
  const BsdfValue value = gloss.evaluate(light->direction);
  if (!(value.density > 0.0f) || (glm::dot(point.facet, light->direction) < 0.0f) != value.transmitted) return;
  const Vec3f radiance =
      ray.throughput * value.cosine_f * light->radiance * (power_heuristic(light->density, value.density) / light->density);
  if (radiance != Vec3f(0.0f) && is_finite(radiance)) to_others_.push(point, *light, radiance, ray.pixel, ray.depth + 1);
}

void LightGatherer::reflect(const ShadingPoint& point, const Bsdf& gloss, const PathRay& ray, float length, Vec2f choice,
                            Vec2f u) {
  const std::optional<BsdfSample> sample = gloss.sample(choice.y, u);
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
