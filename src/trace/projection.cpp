#include "trace/projection.hpp"

#include <numbers>

namespace lippmann {
namespace {

float fraction(float x) {
  const float f = std::fmod(x, 1.0f);
  return f < 0.0f ? f + 1.0f : f;
}

/// In turns, [0, 1]; 0 on the axis.
float angle_around_v(const ImageProjection& p, Vec3f q) {
  const float along_u = glm::dot(q, p.u_axis), along_w = glm::dot(q, glm::cross(p.v_axis, p.u_axis));
  const float turns = std::atan2(along_w, along_u) * (0.5f * std::numbers::inv_pi_v<float>);
  return turns < 0.0f ? turns + 1.0f : turns;
}

/// From -v_axis (0) to v_axis (1).
float angle_from_v(const ImageProjection& p, Vec3f q) {
  const float sine = glm::length(glm::cross(p.v_axis, q)), cosine = -glm::dot(p.v_axis, q);
  return std::atan2(sine, cosine) * std::numbers::inv_pi_v<float>;
}

}  // namespace

ProjectedPoint project(const ImageProjection& p, Vec3f point, float path_length) {
  const Vec3f q = point - p.center;
  const bool plane = p.kind == ProjectionKind::kPlane;
  const float u = plane ? glm::dot(p.u_axis, q) : angle_around_v(p, q);
  const float v = p.kind == ProjectionKind::kSphere ? angle_from_v(p, q) : glm::dot(p.v_axis, q);
  const float length = plane ? path_length : path_length / std::max(8.0f * glm::length(q), 1e-9f);
  const float scale = std::max(std::abs(p.scale.x), std::abs(p.scale.y));
  return {fraction(u * p.scale.x + p.rotate.x), fraction(v * p.scale.y + p.rotate.y), std::min(1.0f, 0.05f * length * scale)};
}

}  // namespace lippmann
