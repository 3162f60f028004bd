#include "trace/path_tracer.hpp"

#include "core/random.hpp"
#include "trace/scene_query.hpp"
#include "trace/shading_point.hpp"

namespace lippmann {
namespace {

/// Paths are first put to Russian roulette where they leave this vertex.
constexpr int kRouletteDepth = 3;

}  // namespace

void FirstSurfaces::add(const ShadingPoint& point, Vec3f normal_there, std::size_t pixel, float weight) const {
  for (int c = 0; c < 3; ++c) {
    albedo[3 * pixel + static_cast<std::size_t>(c)] += weight * point.base_color[c];
    normal[3 * pixel + static_cast<std::size_t>(c)] += weight * normal_there[c];
  }
  z[pixel] += weight * glm::dot(display_z, Vec4f(point.position, 1.0f));
  met[pixel] += weight;
}

Vec4f display_z(const Affine3f& world_from_display) {
  const Affine3f to_display = inverse(world_from_display);
  return {to_display.linear[0].z, to_display.linear[1].z, to_display.linear[2].z, to_display.translation.z};
}

PathTracer::PathTracer(const DeviceScene::Impl& scene, const BeamFootprint& beam, const PathParams& params,
                       const PathFilm& film)
    : scene_(scene), beam_(beam), params_(params), film_(film) {}

void PathTracer::primary(RayHitPacket& packet, const LaneMask& active, const std::uint32_t* pixel, float weight) {
  weight_ = weight;
  clear_hits(packet);
  intersect_scene(scene_, active, packet, Coherence::kCoherent);
  PathRay rays[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    counts_.primary += active.lane[i] != 0;
    rays[i] = primary_path_ray(packet, i, pixel[i]);
    rays[i].seed = hash(params_.seed, pixel[i]), rays[i].index = sample_;
  }
  shade(packet, active, rays);
}

void PathTracer::finish_batch() {
  trace_shadow_rays();
  while (!next_.empty()) {
    std::swap(wave_, next_);
    next_.clear();
    trace_wave(scene_, wave_, [this](const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
      if (probe_) watch_wave(packet, active, rays);
      shade(packet, active, rays);
    });
    trace_shadow_rays();
  }
}

void PathTracer::watch_wave(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
  const LaneMask met = probe_->met(packet.ray, active);
  for (int i = 0; i < kLanes; ++i)
    if (met.lane[i]) (*doubts_)[rays[i].pixel].share += luminance(rays[i].throughput);
}

/// rays: of the active lanes.
void PathTracer::shade(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
  Lanes path_length;
  LaneMask spread;
  for (int i = 0; i < kLanes; ++i) {
    path_length[i] = active.lane[i] ? rays[i].path_length : 0.0f;
    spread.lane[i] = active.lane[i] && rays[i].spread ? -1 : 0;
  }
  evaluate_surfaces(scene_, packet, active, path_length, beam_, surface_, &spread);
  if (surface_.any_hit) draw_numbers(rays);
  if (surface_.any_miss) look_at_sky(packet.ray);
  for (int i = 0; i < kLanes; ++i) {
    if (!active.lane[i]) continue;
    if (surface_.hit.lane[i])
      shade_surface(packet, i, rays[i]);
    else
      shade_sky(packet, i, rays[i]);
  }
}

/// rays: of the lanes that have hit a surface.
void PathTracer::draw_numbers(const PathRay* rays) {
  PathPairs paths;
  bool last = surface_.any_see_through;
  for (int i = 0; i < kLanes; ++i) {
    const bool hit = surface_.hit.lane[i] != 0;
    paths.seed[i] = hit ? rays[i].seed : 0u;
    paths.index[i] = hit ? rays[i].index : 0u;
    paths.first[i] = hit ? kPairsPerEvent * rays[i].events : 0u;
    last |= hit && rays[i].depth + 1 >= kRouletteDepth;
  }
  // The last pair is seldom asked for.
  for (std::uint32_t p = 0; p < (last ? kPairsPerEvent : kPairsPerEvent - 1); ++p)
    sample_pairs(paths, p, numbers_[p].x.lane, numbers_[p].y.lane);
}

void PathTracer::look_at_sky(const RayPacket& rays) {
  LIPPMANN_FOR_LANES(i) sky_.x[i] = rays.dir_x[i], sky_.y[i] = rays.dir_y[i], sky_.z[i] = rays.dir_z[i];
  scene_.path->lights->environment().radiance(sky_);
}

void PathTracer::shade_sky(const RayHitPacket& packet, int i, const PathRay& ray) {
  const unsigned id = packet.hit.geomID[i];
  if (id >= kLightId && id != kNoId) {  // a bulb: its light is gathered at surfaces, so only mirrors and lenses see it
    if (ray.density == kInfinity) end_path(ray, scene_.lights[id - kLightId].color, 1.0f);
    return;
  }
  if (film_.open && ray.depth == 0) {
    film_.open[ray.pixel] += 1.0f;
    return;
  }
  if (ray.lights_from > static_cast<std::uint16_t>(LightGroup::kSky)) return;
  float share = 1.0f;
  if (ray.density != kInfinity) {
    const LightTable::Sky sky = scene_.path->lights->sky(ray.direction);
    if (ray.lights_from > static_cast<std::uint16_t>(sky.group.begin)) return;
    share = power_heuristic(ray.density, sky.density);
  }
  end_path(ray, {sky_.red[i], sky_.green[i], sky_.blue[i]}, share);
}

void PathTracer::shade_surface(const RayHitPacket& packet, int i, const PathRay& ray) {
  const ShadingPoint point = shading_point(scene_, surface_, i);
  const auto pair = [&](std::size_t p) { return Vec2f(numbers_[p].x[i], numbers_[p].y[i]); };
  const Vec2f choice = pair(0), on_light = pair(1), way = pair(2);
  const float length = ray.path_length + packet.ray.tfar[i];
  const bool covered = point.coverage >= 1.0f;
  const Vec2f chance = covered && ray.depth + 1 < kRouletteDepth ? Vec2f(0.0f) : pair(3);
  if (!covered && !(chance.y < point.coverage)) {
    if (ray.events >= kMostEvents) return;
    next_.push_back(passed(ray, point, length));
    return;
  }
  if (film_.surfaces && ray.depth == 0 && point.scatters)
    film_.surfaces->add(point, surface_.normal.get(i), ray.pixel, weight_);
  if (point.emission != Vec3f(0.0f)) add_emission(packet, i, ray, point.emission);
  if (!point.scatters || ray.depth + 1 > params_.max_depth) return;
  const Bsdf bsdf = bsdf_at(scene_, packet, surface_, i);
  aim_at_light(point, bsdf, ray, choice.x, on_light);
  scatter(point, bsdf, ray, length, choice.y, chance.x, way);
}

void PathTracer::add_emission(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f emission) {
  float share = 1.0f;
  if (ray.density != kInfinity && surface_.record[i] < kPlaneId) {
    const float distance = ray.path_length + packet.ray.tfar[i] - ray.scattered_at;
    const float of_light = scene_.path->lights->density_of(surface_.record[i], packet.hit.primID[i], distance, ray.direction);
    if (of_light > 0.0f && ray.lights_from > static_cast<std::uint16_t>(LightGroup::kLamps)) return;
    share = power_heuristic(ray.density, of_light);
  }
  end_path(ray, emission, share);
}

void PathTracer::aim_at_light(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray, float pick, Vec2f u) {
  const std::optional<LightSample> light = scene_.path->lights->sample(point.position, pick, u);
  if (!light) return;
  Vec3f radiance;
  const BsdfValue value = bsdf.evaluate(light->direction);
  // Behind the facet there is only what is transmitted, whatever the smooth normal says, and before it only what is not.
  if ((glm::dot(point.facet, light->direction) < 0.0f) != value.transmitted) return;
  if (light->is_point()) {
    radiance = (value.cosine_f + bsdf.highlight(light->direction)) * light->radiance;
  } else {
    radiance = value.cosine_f * light->radiance * (power_heuristic(light->density, value.density) / light->density);
  }
  radiance *= ray.throughput;
  if (radiance == Vec3f(0.0f) || !is_finite(radiance)) return;
  shadow_rays_.push(point, *light, clamped(radiance, ray.depth + 1), ray.pixel, ray.depth + 1);
}

void PathTracer::scatter(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray, float length, float lobe,
                         float survival, Vec2f u) {
  const std::optional<BsdfSample> sample = bsdf.sample(lobe, u);
  if (!sample) return;
  if ((glm::dot(point.facet, sample->direction) < 0.0f) != sample->transmitted) return;
  Vec3f throughput = ray.throughput * sample->weight;
  if (ray.depth + 1 >= kRouletteDepth) {
    const float chance = std::min(0.95f, largest(throughput));
    if (!(survival < chance)) return;
    throughput /= chance;
  }
  if (throughput == Vec3f(0.0f) || !is_finite(throughput)) return;
  ++(sample->is_delta() ? counts_.reflection : counts_.indirect);
  lippmann::scatter(next_.emplace_back(ray), point, *sample, throughput, length);
}

void PathTracer::gather_diffuse(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray, float length, LightGroup from,
                                const Numbers& numbers, const Affine3f* before) {
  const LightTable& lights = *scene_.path->lights;
  if (const std::optional<LightSample> light =
          lights.sample({from, LightGroup::kEnd}, point.position, numbers.pick, numbers.on_light)) {
    const BsdfValue value = bsdf.evaluate_diffuse(light->direction);
    if (before) watch_turning(point.position, bsdf.normal(), *light, *before, ray);
    const float share = power_heuristic(light->density, value.density) / light->density;
    const Vec3f radiance = ray.throughput * value.cosine_f * light->radiance * share;
    if (glm::dot(point.facet, light->direction) > 0.0f && radiance != Vec3f(0.0f) && is_finite(radiance))
      shadow_rays_.push(point, *light, radiance, ray.pixel, ray.depth + 1);
  }
  BsdfSample sample;
  sample.direction = Frame(bsdf.normal()).to_world(sample_cosine(numbers.way));
  const BsdfValue value = bsdf.evaluate_diffuse(sample.direction);
  if (!(value.density > 0.0f) || !(glm::dot(point.facet, sample.direction) > 0.0f)) return;
  if (before) {
    const float cosine = glm::dot(bsdf.normal(), sample.direction);
    const float cosine_before = std::max(0.0f, glm::dot(before->linear * bsdf.normal(), sample.direction));
    (*doubts_)[ray.pixel].turned_share += luminance(ray.throughput) * std::abs(cosine_before / cosine - 1.0f);
  }
  // What the path meets compares its density with that of sample(), whose light is a point-like one at times.
  const float chance = lights.chance({from, LightGroup::kEnd});
  sample.density = chance > 0.0f ? value.density * chance : value.density;
  ++counts_.indirect;
  next_.push_back(scattered(ray, point, sample, ray.throughput * value.cosine_f / value.density, length));
  next_.back().lights_from = static_cast<std::uint16_t>(from);
}

/// What the light sends there, by Lambert's law, less what it sent to where the surface was.
void PathTracer::watch_turning(Vec3f position, Vec3f normal, const LightSample& light, const Affine3f& before,
                               const PathRay& ray) {
  const float cosine = std::max(0.0f, glm::dot(normal, light.direction));
  Vec3f way = light.direction;
  float nearer = 1.0f;  // than it is now, squared
  if (std::isfinite(light.distance)) {
    way = position + light.distance * light.direction - transform_point(before, position);
    nearer = light.distance * light.distance / std::max(glm::dot(way, way), 1e-20f);
    way = glm::normalize(way);
  }
  const float cosine_before = std::max(0.0f, glm::dot(before.linear * normal, way));
  const float per_cosine = luminance(ray.throughput * light.radiance) / (kPi * light.density);
  (*doubts_)[ray.pixel].turned_light += per_cosine * (cosine - nearer * cosine_before);
}

void PathTracer::trace_shadow_rays() {
  if (probe_)
    shadow_rays_.probe(*probe_, [this](const ShadowRay& ray) { (*doubts_)[ray.pixel].light += luminance(ray.radiance); });
  counts_.shadow +=
      shadow_rays_.trace(scene_, [this](const ShadowRay& ray, Vec3f radiance) { add(ray.pixel, radiance, ray.depth); });
}

void PathTracer::end_path(const PathRay& ray, Vec3f light, float share) {
  add(ray.pixel, clamped(ray.throughput * light * share, ray.depth), ray.depth);
}

/// Emission that a path meets at its second vertex is direct light of the first; what comes later is indirect.
Vec3f PathTracer::clamped(Vec3f radiance, int depth) const {
  const float most = largest(radiance);
  return params_.clamp_indirect > 0.0f && depth > 1 && most > params_.clamp_indirect
             ? radiance * (params_.clamp_indirect / most)
             : radiance;
}

/// depth: vertices that have scattered it.
void PathTracer::add(std::uint32_t pixel, Vec3f radiance, int depth) {
  const auto add_weighted = [&](float* film, float weight) {
    float* p = film + 3 * static_cast<std::size_t>(pixel);
    for (int c = 0; c < 3; ++c) p[c] += weight * radiance[c];
  };
  const auto add_to = [&](float* film) { add_weighted(film, weight_); };
  add_to(film_.all);
  if (float* part = depth > 1 ? film_.indirect : film_.direct) add_to(part);
  if (film_.seen && depth == 0) add_to(film_.seen);
  if (film_.noise) add_weighted(film_.noise, weight_ * noise_weight_);
}

}  // namespace lippmann
