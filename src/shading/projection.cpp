#include "shading/projection.hpp"

#include <algorithm>
#include <numbers>

namespace lippmann {
namespace {

LIPPMANN_INLINE float fraction(float x) { return std::min(std::max(0.0f, x - std::floor(x)), 1.0f); }

/// Returns the angle of q around v_axis in turns, from 0 to 1, or 0 if q lies on the axis.
float angle_around_v(const ImageProjection& p, Vec3f q) {
  const float along_u = glm::dot(q, p.u_axis), along_w = glm::dot(q, glm::cross(p.v_axis, p.u_axis));
  const float turns = std::atan2(along_w, along_u) * (0.5f * std::numbers::inv_pi_v<float>);
  return turns < 0.0f ? turns + 1.0f : turns;
}

/// Returns the angle between q and -v_axis in half turns: 0 if q points along -v_axis, 1 along v_axis.
float angle_from_v(const ImageProjection& p, Vec3f q) {
  const float sine = glm::length(glm::cross(p.v_axis, q)), cosine = -glm::dot(p.v_axis, q);
  return std::atan2(sine, cosine) * std::numbers::inv_pi_v<float>;
}

LIPPMANN_MULTIVERSION void project_plane(const ImageProjection& p, const Lanes3& q, ProjectedLanes& at) {
  LIPPMANN_FOR_LANES(i) {
    at.u[i] = p.u_axis.x * q.x[i] + p.u_axis.y * q.y[i] + p.u_axis.z * q.z[i];
    at.v[i] = p.v_axis.x * q.x[i] + p.v_axis.y * q.y[i] + p.v_axis.z * q.z[i];
  }
}

void project_around_axis(const ImageProjection& p, const Lanes3& q, ProjectedLanes& at) {
  for (int i = 0; i < kLanes; ++i) {
    at.u[i] = angle_around_v(p, q.get(i));
    at.v[i] = p.kind == ProjectionKind::kSphere ? angle_from_v(p, q.get(i)) : glm::dot(p.v_axis, q.get(i));
  }
}

LIPPMANN_MULTIVERSION void relative_to_center(Vec3f center, const Lanes3& point, const LaneMask& wanted, Lanes3& q) {
  LIPPMANN_FOR_LANES(i) {
    const bool there = wanted.lane[i] != 0;
    q.x[i] = there ? point.x[i] - center.x : 0.0f;
    q.y[i] = there ? point.y[i] - center.y : 0.0f;
    q.z[i] = there ? point.z[i] - center.z : 0.0f;
  }
}

LIPPMANN_MULTIVERSION void place_on_picture(const ImageProjection& p, const Lanes3& q, const Lanes& path_length,
                                            const LaneMask& wanted, ProjectedLanes& at) {
  const float whole_path = p.kind == ProjectionKind::kPlane ? 1.0f : 0.0f;
  const float scale_u = p.scale.x, scale_v = p.scale.y, move_u = p.rotate.x, move_v = p.rotate.y;
  const float scale = std::max(std::abs(scale_u), std::abs(scale_v));
  LIPPMANN_FOR_LANES(i) {
    const float distance = std::sqrt(q.x[i] * q.x[i] + q.y[i] * q.y[i] + q.z[i] * q.z[i]);
    const float divisor = whole_path + (1.0f - whole_path) * std::max(8.0f * distance, 1e-9f);
    const float length = (wanted.lane[i] != 0 ? path_length[i] : 0.0f) / divisor;
    at.u[i] = fraction(at.u[i] * scale_u + move_u);
    at.v[i] = fraction(at.v[i] * scale_v + move_v);
    at.blur[i] = std::min(1.0f, 0.05f * length * scale);
  }
}

}  // namespace

void project(const ImageProjection& projection, const Lanes3& point, const Lanes& path_length, const LaneMask& wanted,
             ProjectedLanes& at) {
  Lanes3 q;
  relative_to_center(projection.center, point, wanted, q);
  if (projection.kind == ProjectionKind::kPlane)
    project_plane(projection, q, at);
  else
    project_around_axis(projection, q, at);
  place_on_picture(projection, q, path_length, wanted, at);
}

}  // namespace lippmann
