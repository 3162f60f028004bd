// Lights that shine on vertices of paths unless something lies between: they wait until there are packets of them.
#pragma once

#include <vector>

#include "device/touch_probe.hpp"
#include "shading/direct_light.hpp"
#include "shading/light_table.hpp"
#include "shading/shading_point.hpp"

namespace lippmann {

struct ShadowRay {
  Vec3f origin, direction, radiance;
  float t_near, t_far;
  std::uint32_t pixel;
  int depth;  ///< vertices that scatter it
};

class ShadowQueue {
 public:
  /// From a point to a light; `radiance` arrives at `pixel` where nothing lies between, scattered by `depth` vertices.
  void push(const ShadingPoint& point, const LightSample& light, const Vec3f& radiance, std::uint32_t pixel, int depth) {
    ShadowRay& ray = rays_.emplace_back();  // filled in place: copies of what has just been written wait for it
    ray.origin = point.position, ray.direction = light.direction;
    ray.radiance = radiance;
    ray.t_near = point.t_near;
    const float distance = point.rises_to(light.direction) ? lift(point, light.distance, ray) : light.distance;
    ray.t_far = light.is_point() || distance == kInfinity ? distance : distance - point.t_near;
    ray.pixel = pixel, ray.depth = depth;
  }

  /// Lane i of rays that were aimed at a light.
  void push(const ShadowPacket& aimed, int i, const Vec3f& radiance, std::uint32_t pixel, int depth) {
    ShadowRay& ray = rays_.emplace_back();
    ray.origin = {aimed.rays.org_x[i], aimed.rays.org_y[i], aimed.rays.org_z[i]};
    ray.direction = {aimed.rays.dir_x[i], aimed.rays.dir_y[i], aimed.rays.dir_z[i]};
    ray.radiance = radiance;
    ray.t_near = aimed.rays.tnear[i], ray.t_far = aimed.rays.tfar[i];
    ray.pixel = pixel, ray.depth = depth;
  }

  /// Calls met(shadow ray) for all that wait and would pass one of the probe's boxes on their way to the light.
  template <class Met>
  void probe(const TouchProbe& probe, const Met& met) {
    for (std::size_t first = 0; first < rays_.size(); first += kLanes) {
      const std::size_t count = fill_packet(first);
      const LaneMask lanes = probe.met(packet_.rays, packet_.active);
      for (std::size_t i = 0; i < count; ++i)
        if (lanes.lane[i]) met(rays_[first + i]);
    }
  }

  /// Traces all that wait, calls add(shadow ray, radiance) for what arrives, in the order of push(), and returns how many there
  /// were.
  template <class Add>
  std::size_t trace(const ShadedScene& scene, const Add& add) {
    for (std::size_t first = 0; first < rays_.size(); first += kLanes) {
      const std::size_t count = trace_packet(scene, first);
      for (std::size_t i = 0; i < count; ++i)
        if (arrives(static_cast<int>(i)))
          add(rays_[first + i], rays_[first + i].radiance * packet_.transmittance.at(static_cast<int>(i)));
    }
    const std::size_t all = rays_.size();
    rays_.clear();
    return all;
  }

 private:
  static float lift(const ShadingPoint& point, float distance, ShadowRay& ray);
  std::size_t fill_packet(std::size_t first);
  std::size_t trace_packet(const ShadedScene& scene, std::size_t first);
  bool arrives(int i) const { return packet_.active.lane[i] && packet_.rays.tfar[i] >= 0.0f; }

  std::vector<ShadowRay> rays_;
  ShadowPacket packet_;
};

}  // namespace lippmann
