// Affine transforms in double precision, for large worlds.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

struct Affine3d {
  glm::dmat3 linear{1.0};
  glm::dvec3 translation{0.0};
  bool operator==(const Affine3d&) const = default;
};

inline Affine3d to_double(const Affine3f& a) { return {glm::dmat3(a.linear), glm::dvec3(a.translation)}; }

inline Affine3d operator*(const Affine3d& a, const Affine3d& b) {
  return {a.linear * b.linear, a.linear * b.translation + a.translation};
}

inline Affine3d inverse(const Affine3d& a) {
  const glm::dmat3 m = glm::inverse(a.linear);
  return {m, -(m * a.translation)};
}

inline glm::dvec3 transform_point(const Affine3d& a, glm::dvec3 p) { return a.linear * p + a.translation; }

/// Returns the world-space transform that moves a node from the pose `from` to the pose `to`: exactly the identity if both are
/// equal.
inline Affine3d world_motion(const Affine3f& from, const Affine3f& to) {
  return from == to ? Affine3d{} : to_double(to) * inverse(to_double(from));
}

}  // namespace lippmann
