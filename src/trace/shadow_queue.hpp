// The queue of shadow rays of path vertices, traced in packets.
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
  int depth;  ///< number of vertices that have scattered the light
};

class ShadowQueue {
 public:
  /// Queues a ray from a point to a light. If the ray is unoccluded, `pixel` receives `radiance`, which `depth` vertices have
  /// scattered.
  void push(const ShadingPoint& point, const LightSample& light, const Vec3f& radiance, std::uint32_t pixel, int depth) {
    // Fill the ray in place: copying a struct that was just written would stall on store forwarding.
    ShadowRay& ray = rays_.emplace_back();
    ray.origin = point.position, ray.direction = light.direction;
    ray.radiance = radiance;
    ray.t_near = point.t_near;
    const float distance = point.rises_to(light.direction) ? lift(point, light.distance, ray) : light.distance;
    ray.t_far = light.is_point() || distance == kInfinity ? distance : distance - point.t_near;
    ray.pixel = pixel, ray.depth = depth;
  }

  /// Traces all queued rays. Calls add(shadow ray, radiance) for rays that are not fully occluded. Returns the number of traced
  /// rays.
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
