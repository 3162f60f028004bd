#include "shading/tree_lights.hpp"

#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

float half_angle_of(const WhittedLight& lamp) {
  if (lamp.has_cone > 0.0f) return std::acos(std::clamp(lamp.cos_outer, -1.0f, 1.0f));
  return lamp.linear_cone ? lamp.outer_cone : kPi;
}

float inner_angle_of(const WhittedLight& lamp) {
  if (lamp.has_cone > 0.0f) return std::acos(std::clamp(lamp.cos_outer + 1.0f / lamp.inverse_ramp, -1.0f, 1.0f));
  return half_angle_of(lamp);
}

}  // namespace

TreeLight tree_light(const WhittedLight& lamp, const WebBeam* beam) {
  TreeLight light;
  if (!(lamp.at_place > 0.0f) || !(lamp.falls_off > 0.0f) || lamp.attenuates) return light;
  light.middle = lamp.position;
  light.power = luminance(lamp.color);
  light.radius = lamp.radius, light.variance = lamp.radius * lamp.radius;
  light.range = lamp.range;
  light.axis = -lamp.toward, light.half_angle = half_angle_of(lamp);
  light.inner_angle = inner_angle_of(lamp);
  if (beam) {
    light.axis = beam->axis * lamp.light_from_world;
    light.half_angle = beam->half_angle;
    light.profile = &beam->profile;
  }
  return light;
}

/// The variance is the mean squared distance of a triangle's points from its centroid, 1/36 of the sum of its squared edge
/// lengths.
TreeLight tree_light(Vec3f origin, Vec3f edge_b, Vec3f edge_c, float power, BodyFacing closed) {
  TreeLight light;
  const Vec3f middle = (edge_b + edge_c) / 3.0f, across = edge_c - edge_b;
  light.middle = origin + middle;
  light.power = power;
  light.variance = (glm::dot(edge_b, edge_b) + glm::dot(edge_c, edge_c) + glm::dot(across, across)) / 36.0f;
  light.radius = std::max({glm::length(middle), glm::length(edge_b - middle), glm::length(edge_c - middle)});
  light.face = glm::normalize(glm::cross(edge_b, edge_c));
  if (closed == BodyFacing::kInward) light.face = -light.face;
  light.is_closed = closed != BodyFacing::kNone;
  return light;
}

}  // namespace lippmann
