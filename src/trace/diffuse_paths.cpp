// Paths that begin on a diffuse surface, for what it receives from all around, and how much of that may have changed since the
// frame before.
#include "trace/path_integrator.hpp"
#include "transport/bsdf.hpp"
#include "transport/sampling.hpp"

namespace lippmann {

void PathIntegrator::gather_diffuse(const DiffuseVertex& at, const PathRay& ray, LightGroup from,
                                    const std::optional<LightSample>& light, Vec2f way) {
  if (light) aim_at(at, ray, *light);
  std::optional<PathRay> path = bounce(at, ray, from, way);
  if (!path) return;
  // What the path meets compares its density with that of sample(), whose light is a point-like one at times.
  const float chance = lights().chance({from, LightGroup::kEnd}, {at.point.position, at.bsdfs.normal(at.lane)});
  if (chance > 0.0f) path->density *= chance;
  next_.push_back(*path);
}

void PathIntegrator::aim_at(const DiffuseVertex& at, const PathRay& ray, const LightSample& light) {
  const ShadingPoint& point = at.point;
  const BsdfValue value = at.bsdfs.evaluate_diffuse(at.lane, light.direction);
  if (at.before) watch_turning(at, light, ray);
  const float share = power_heuristic(light.density, point.rises_to(light.direction) ? 0.0f : value.density) / light.density;
  const Vec3f radiance = ray.throughput * value.cosine_f * light.radiance * share;
  if (may_shine(point, light.direction, value.transmitted) && radiance != Vec3f(0.0f) && is_finite(radiance))
    shadow_rays_.push(point, light, radiance, ray.pixel, ray.depth + 1);
}

std::optional<PathRay> PathIntegrator::bounce(const DiffuseVertex& at, const PathRay& ray, LightGroup from, Vec2f way) {
  const auto& [point, bsdfs, lane, length, before] = at;
  const Vec3f normal = bsdfs.normal(lane);
  BsdfSample sample;
  sample.direction = Frame(normal).to_world(sample_cosine(way));
  const BsdfValue value = bsdfs.evaluate_diffuse(lane, sample.direction);
  if (!(value.density > 0.0f) || !(glm::dot(point.facet, sample.direction) > 0.0f)) return std::nullopt;
  if (before) {
    const float cosine = glm::dot(normal, sample.direction);
    const float cosine_before = std::max(0.0f, glm::dot(before->linear * normal, sample.direction));
    (*changes_)[ray.pixel].turned_share += luminance(ray.throughput) * std::abs(cosine_before / cosine - 1.0f);
  }
  sample.density = value.density;
  ++counts_.indirect;
  PathRay path = scattered(ray, point, normal, sample, ray.throughput * value.cosine_f / value.density, length);
  path.lights_from = static_cast<std::uint16_t>(from);
  return path;
}

void PathIntegrator::watch_packet(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
  const LaneMask met = probe_->met(packet.ray, active);
  for (int i = 0; i < kLanes; ++i)
    if (met.lane[i]) (*changes_)[rays[i].pixel].share += luminance(rays[i].throughput);
}

/// What the light sends there, by Lambert's law, less what it sent to where the surface was.
void PathIntegrator::watch_turning(const DiffuseVertex& at, const LightSample& light, const PathRay& ray) {
  const Vec3f position = at.point.position, normal = at.bsdfs.normal(at.lane);
  const Affine3f& before = *at.before;
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
  (*changes_)[ray.pixel].turned_light += per_cosine * (cosine - nearer * cosine_before);
}

}  // namespace lippmann
