// Adds the light of the emitters that path rays hit. The power heuristic weights light that the last vertex could also have
// sampled by a shadow ray.
#include "trace/path_integrator.hpp"

namespace lippmann {

/// Adds the light of splats to rays that a camera sees directly or by specular reflection or transmission. Attenuates the
/// throughput, and deactivates lanes with throughput 0.
void PathIntegrator::meet_splats(const RayPacket& packet, LaneMask& active, PathRay* rays) {
  LaneMask looking;
  for (int i = 0; i < kLanes; ++i) looking.lane[i] = active.lane[i] && rays[i].density == kInfinity ? -1 : 0;
  SplatLight light;
  see_splats(scene_, looking, packet, splat_hits_, light);
  for (int i = 0; i < kLanes; ++i) {
    if (!looking.lane[i]) continue;
    if (const Vec3f radiance = rays[i].throughput * light.radiance.get(i); radiance != Vec3f(0.0f)) end_path(rays[i], radiance);
    rays[i].throughput *= light.passed[i];
    if (!(light.passed[i] > 0.0f)) active.lane[i] = 0;
  }
}

/// Lamps with a finite size do not block rays.
void PathIntegrator::meet_round_lights(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
  if (lights().has_many_rounds()) {
    for (int i = 0; i < kLanes; ++i)
      if (active.lane[i] && rays[i].has_scattered())
        lights().meet_rounds(rays[i].origin, rays[i].direction, packet.ray.tfar[i],
                             [&](std::size_t k) { meet_round_light(k, rays[i], packet.ray.tfar[i]); });
    return;
  }
  for (std::size_t k = 0; k < lights().rounds(); ++k) {
    if (!lights().is_pointed_at(k, packet.ray)) continue;
    for (int i = 0; i < kLanes; ++i)
      if (active.lane[i]) meet_round_light(k, rays[i], packet.ray.tfar[i]);
  }
}

/// Adds the light of lamp `k` if the ray hits it within `reach`. Camera rays do not see lamps.
void PathIntegrator::meet_round_light(std::size_t k, const PathRay& ray, float reach) {
  if (!ray.has_scattered()) return;
  const float passed = ray.path_length - ray.scattered_at;
  const LightReceiver at = last_receiver(ray);
  const std::optional<LightSample> light = lights().see_round(k, at.position, ray.direction);
  if (!light || !(light->distance > passed) || !(light->distance <= passed + reach)) return;
  float share = 1.0f;
  if (ray.density != kInfinity) share = power_heuristic(ray.density, light->density * lights().chance_of_round(k, at));
  end_path(ray, ray.throughput * light->radiance * share);
}

void PathIntegrator::look_up_sky(const RayPacket& rays) {
  LIPPMANN_FOR_LANES(i) sky_.x[i] = rays.dir_x[i], sky_.y[i] = rays.dir_y[i], sky_.z[i] = rays.dir_z[i];
  lights().environment().radiance(sky_);
}

void PathIntegrator::shade_miss(const RayHitPacket& packet, int i, const PathRay& ray) {
  const unsigned id = packet.hit.geomID[i];
  // Only camera rays and rays of Dirac lobes add the light, because other vertices sample it by shadow rays.
  if (id >= kLightId && id != kNoId) {
    if (ray.density == kInfinity) end_path(ray, ray.throughput * scene_.lights[id - kLightId].color);
    return;
  }
  if (film_.open && ray.has_met_nothing()) {
    film_.open[ray.pixel] += ray.throughput.x;  // the throughput is 1, or the transmittance of splats
    return;
  }
  float share = 1.0f;
  if (ray.density != kInfinity) share = power_heuristic(ray.density, lights().density_of_sky(sky_, i, last_receiver(ray)));
  end_path(ray, ray.throughput * Vec3f(sky_.red[i], sky_.green[i], sky_.blue[i]) * share);
}

void PathIntegrator::meet_emission(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f emission) {
  float share = 1.0f;
  if (ray.density != kInfinity && surface_.record[i] < kPlaneId) {
    const float distance = ray.path_length + packet.ray.tfar[i] - ray.scattered_at;
    const float density =
        lights().density_of(surface_.record[i], packet.hit.primID[i], distance, ray.direction, last_receiver(ray));
    share = power_heuristic(ray.density, density);
  }
  end_path(ray, ray.throughput * emission * share);
}

}  // namespace lippmann
