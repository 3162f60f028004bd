// Lights that shine on vertices of paths unless something lies between: they wait until there are packets of them.
#pragma once

#include <vector>

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
  std::size_t trace_packet(const ShadedScene& scene, std::size_t first);
  bool arrives(int i) const { return packet_.active.lane[i] && packet_.rays.tfar[i] >= 0.0f; }

  std::vector<ShadowRay> rays_;
  ShadowPacket packet_;
};

}  // namespace lippmann
