// Vectors (glm), affine transforms and bounds. Vectors are columns: a product of transforms applies the rightmost factor first.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace lippmann {

using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;
using Vec2i = glm::ivec2;
using Mat3f = glm::mat3;  ///< stored column by column
using Quatf = glm::quat;  ///< glm's constructor takes (w, x, y, z)

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kPi = std::numbers::pi_v<float>;

inline constexpr float radians(float degrees) { return degrees * (kPi / 180.0f); }
inline constexpr float degrees(float radians) { return radians * (180.0f / kPi); }
inline constexpr float squared(float x) { return x * x; }

/// The map p -> linear * p + translation.
struct Affine3f {
  Mat3f linear{1.0f};
  Vec3f translation{0.0f};
};

inline Vec3f transform_point(const Affine3f& a, Vec3f p) { return a.linear * p + a.translation; }
inline Vec3f transform_vector(const Affine3f& a, Vec3f v) { return a.linear * v; }
/// Transforms a normal by the inverse transpose. The result is not normalised. The linear part must be invertible.
inline Vec3f transform_normal(const Affine3f& a, Vec3f n) { return glm::transpose(glm::inverse(a.linear)) * n; }
inline Affine3f operator*(const Affine3f& a, const Affine3f& b) {
  return {a.linear * b.linear, a.linear * b.translation + a.translation};
}
inline bool operator==(const Affine3f& a, const Affine3f& b) { return a.linear == b.linear && a.translation == b.translation; }
inline Affine3f inverse(const Affine3f& a) {
  const Mat3f m = glm::inverse(a.linear);
  return {m, -(m * a.translation)};
}
/// Returns the cube root of the factor by which a transform scales volumes. For similarities, this is the scale of lengths.
inline float uniform_scale(const Affine3f& a) { return std::cbrt(std::abs(glm::determinant(a.linear))); }

struct Bounds3f {
  Vec3f lower{kInfinity};
  Vec3f upper{-kInfinity};

  bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
  void add(Vec3f p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
  void add(const Bounds3f& b) { lower = glm::min(lower, b.lower), upper = glm::max(upper, b.upper); }
  Vec3f center() const { return 0.5f * (lower + upper); }
  Vec3f size() const { return upper - lower; }
};

/// Returns the axis-aligned box around the transformed box `b`.
inline Bounds3f transform_bounds(const Affine3f& a, const Bounds3f& b) {
  Bounds3f r;
  if (b.empty()) return r;
  for (int corner = 0; corner < 8; ++corner)
    r.add(transform_point(
        a, {corner & 1 ? b.upper.x : b.lower.x, corner & 2 ? b.upper.y : b.lower.y, corner & 4 ? b.upper.z : b.lower.z}));
  return r;
}

}  // namespace lippmann
