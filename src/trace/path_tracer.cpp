#include "trace/path_tracer.hpp"

#include "core/random.hpp"
#include "trace/scene_query.hpp"
#include "trace/shading_point.hpp"
#include "transport/sampler.hpp"

namespace lippmann {
namespace {

/// Paths are first put to Russian roulette where they leave this vertex.
constexpr int kRouletteDepth = 3;
/// A surface that lets light pass is no vertex of a path, but however many of them there are, it must come to an end.
constexpr int kMostEvents = 1024;
/// Pairs of random numbers at each vertex: which light and lobe; where on the light; which way; roulette and coverage.
constexpr std::uint32_t kPairsPerEvent = 4;

float largest(Vec3f v) { return std::max({v.x, v.y, v.z}); }

bool is_finite(Vec3f v) { return std::isfinite(v.x + v.y + v.z); }

}  // namespace

PathTracer::PathTracer(const DeviceScene::Impl& scene, const BeamFootprint& beam, const PathParams& params,
                       const PathFilm& film)
    : scene_(scene), beam_(beam), params_(params), film_(film) {}

void PathTracer::primary(RayHitPacket& packet, const LaneMask& active, const std::uint32_t* pixel, float weight) {
  weight_ = weight;
  clear_hits(packet);
  intersect_scene(scene_, active, packet, Coherence::kCoherent);
  Ray rays[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    counts_.primary += active.lane[i] != 0;
    rays[i] = {Vec3f(0.0f), Vec3f(0.0f), Vec3f(1.0f), 0.0f, 0.0f, 0.0f, kInfinity, pixel[i], 0, 0};
    rays[i].origin = {packet.ray.org_x[i], packet.ray.org_y[i], packet.ray.org_z[i]};
    rays[i].direction = {packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]};
  }
  shade(packet, active, rays);
}

void PathTracer::finish_batch() {
  trace_shadow_rays();
  while (!next_.empty()) {
    std::swap(wave_, next_);
    next_.clear();
    RayHitPacket packet;
    LaneMask active;
    for (std::size_t first = 0; first < wave_.size(); first += kLanes) {
      load(first, std::min<std::size_t>(kLanes, wave_.size() - first), packet, active);
      clear_hits(packet);
      intersect_scene(scene_, active, packet, Coherence::kIncoherent);
      shade(packet, active, wave_.data() + first);
    }
    trace_shadow_rays();
  }
}

void PathTracer::load(std::size_t first, std::size_t count, RayHitPacket& packet, LaneMask& active) const {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const Ray& ray = wave_[first + std::min(i, count - 1)];
    packet.ray.org_x[i] = ray.origin.x, packet.ray.org_y[i] = ray.origin.y, packet.ray.org_z[i] = ray.origin.z;
    packet.ray.dir_x[i] = ray.direction.x, packet.ray.dir_y[i] = ray.direction.y, packet.ray.dir_z[i] = ray.direction.z;
    packet.ray.tnear[i] = ray.t_near;
    packet.ray.tfar[i] = kInfinity;
    active.lane[i] = i < count ? -1 : 0;
  }
}

/// rays: of the active lanes.
void PathTracer::shade(const RayHitPacket& packet, const LaneMask& active, const Ray* rays) {
  Lanes path_length;
  for (int i = 0; i < kLanes; ++i) path_length[i] = active.lane[i] ? rays[i].path_length : 0.0f;
  evaluate_surfaces(scene_, packet, active, path_length, beam_, surface_);
  for (int i = 0; i < kLanes; ++i) {
    if (!active.lane[i]) continue;
    if (surface_.hit.lane[i])
      shade_surface(packet, i, rays[i]);
    else
      shade_sky(packet, i, rays[i]);
  }
}

void PathTracer::shade_sky(const RayHitPacket& packet, int i, const Ray& ray) {
  const unsigned id = packet.hit.geomID[i];
  if (id >= kLightId && id != kNoId) {  // a bulb: its light is gathered at surfaces, so only mirrors and lenses see it
    if (ray.density == kInfinity) end_path(ray, scene_.lights[id - kLightId].color, 1.0f);
    return;
  }
  if (film_.open && ray.depth == 0) {
    film_.open[ray.pixel] += 1.0f;
    return;
  }
  const LightTable& lights = *scene_.path->lights;
  const float share = ray.density == kInfinity ? 1.0f : power_heuristic(ray.density, lights.density_of_sky(ray.direction));
  end_path(ray, lights.environment().radiance(ray.direction), share);
}

void PathTracer::shade_surface(const RayHitPacket& packet, int i, const Ray& ray) {
  const ShadingPoint point = shading_point(scene_, packet, surface_, i);
  PathSampler sampler(hash(params_.seed, ray.pixel), sample_);
  sampler.jump_to(kPairsPerEvent * ray.events);
  const Vec2f choice = sampler.next(), on_light = sampler.next(), way = sampler.next();
  const float length = ray.path_length + packet.ray.tfar[i];
  // The last pair is seldom asked for.
  const bool covered = point.coverage >= 1.0f;
  const Vec2f chance = covered && ray.depth + 1 < kRouletteDepth ? Vec2f(0.0f) : sampler.next();
  if (!covered && !(chance.y < point.coverage)) {
    if (ray.events >= kMostEvents) return;
    next_.push_back(ray);
    next_.back().origin = point.position;
    next_.back().t_near = point.t_near;
    next_.back().path_length = length;
    ++next_.back().events;
    return;
  }
  if (film_.surfaces && ray.depth == 0 && point.scatters) add_first_surface(point, i, ray);
  if (point.emission != Vec3f(0.0f)) add_emission(packet, i, ray, point.emission);
  if (!point.scatters || ray.depth + 1 > params_.max_depth) return;
  const Bsdf bsdf = bsdf_at(scene_, packet, surface_, i);
  aim_at_light(point, bsdf, ray, choice.x, on_light);
  scatter(point, bsdf, ray, length, choice.y, chance.x, way);
}

void PathTracer::add_emission(const RayHitPacket& packet, int i, const Ray& ray, Vec3f emission) {
  float share = 1.0f;
  if (ray.density != kInfinity && surface_.record[i] < kPlaneId) {
    const float distance = ray.path_length + packet.ray.tfar[i] - ray.scattered_at;
    const float of_light = scene_.path->lights->density_of(surface_.record[i], packet.hit.primID[i], distance, ray.direction);
    share = power_heuristic(ray.density, of_light);
  }
  end_path(ray, emission, share);
}

void PathTracer::aim_at_light(const ShadingPoint& point, const Bsdf& bsdf, const Ray& ray, float pick, Vec2f u) {
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
  const float t_far = light->is_point() || light->distance == kInfinity ? light->distance : light->distance - point.t_near;
  shadow_rays_.push_back(
      {point.position, light->direction, clamped(radiance, ray.depth + 1), point.t_near, t_far, ray.pixel, ray.depth + 1});
}

void PathTracer::scatter(const ShadingPoint& point, const Bsdf& bsdf, const Ray& ray, float length, float lobe, float survival,
                         Vec2f u) {
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
  Ray& next = next_.emplace_back(ray);
  next.origin = point.position, next.direction = sample->direction;
  next.throughput = throughput;
  next.t_near = point.t_near, next.path_length = length;
  ++next.depth, ++next.events;
  if (sample->straight) return;  // what shines behind is reached by the last vertex's shadow rays, too
  next.density = sample->density, next.scattered_at = length;
}

void PathTracer::trace_shadow_rays() {
  counts_.shadow += shadow_rays_.size();
  for (std::size_t first = 0; first < shadow_rays_.size(); first += kLanes) {
    const std::size_t count = std::min<std::size_t>(kLanes, shadow_rays_.size() - first);
    for (std::size_t i = 0; i < kLanes; ++i) {
      const ShadowRay& ray = shadow_rays_[first + std::min(i, count - 1)];
      shadow_.rays.org_x[i] = ray.origin.x, shadow_.rays.org_y[i] = ray.origin.y, shadow_.rays.org_z[i] = ray.origin.z;
      shadow_.rays.dir_x[i] = ray.direction.x, shadow_.rays.dir_y[i] = ray.direction.y, shadow_.rays.dir_z[i] = ray.direction.z;
      shadow_.rays.tnear[i] = ray.t_near, shadow_.rays.tfar[i] = ray.t_far;
      shadow_.active.lane[i] = i < count ? -1 : 0;
      shadow_.context.transmittance[i] = 1.0f;
    }
    trace_shadows(scene_, shadow_);
    for (std::size_t i = 0; i < count; ++i) {
      if (!shadow_.active.lane[i] || !(shadow_.rays.tfar[i] >= 0.0f)) continue;
      const ShadowRay& ray = shadow_rays_[first + i];
      add(ray.pixel, ray.radiance * shadow_.context.transmittance[i], ray.depth);
    }
  }
  shadow_rays_.clear();
}

void PathTracer::add_first_surface(const ShadingPoint& point, int i, const Ray& ray) {
  const FirstSurfaces& to = *film_.surfaces;
  const std::size_t pixel = ray.pixel;
  for (int c = 0; c < 3; ++c) {
    to.albedo[3 * pixel + static_cast<std::size_t>(c)] += weight_ * point.base_color[c];
    to.normal[3 * pixel + static_cast<std::size_t>(c)] += weight_ * surface_.normal.get(i)[c];
  }
  to.z[pixel] += weight_ * glm::dot(to.display_z, Vec4f(point.position, 1.0f));
  to.met[pixel] += weight_;
}

void PathTracer::end_path(const Ray& ray, Vec3f light, float share) {
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
  const auto add_to = [&](float* film) {
    float* p = film + 3 * static_cast<std::size_t>(pixel);
    for (int c = 0; c < 3; ++c) p[c] += weight_ * radiance[c];
  };
  add_to(film_.all);
  if (float* part = depth > 1 ? film_.indirect : film_.direct) add_to(part);
  if (film_.seen && depth == 0) add_to(film_.seen);
  if (film_.odd && (sample_ & 1u) != 0) add_to(film_.odd);
}

}  // namespace lippmann
