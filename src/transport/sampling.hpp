// Samples directions and points by two random numbers in [0, 1).
//
// Based on: P. Shirley, K. Chiu, "A Low Distortion Map Between Disk and Square", JGT 2(3), 1997; T. Duff et al., "Building an
// Orthonormal Basis, Revisited", JCGT 6(1), 2017.
#pragma once

#include "transport/fast_angles.hpp"

namespace lippmann {

struct Basis {
  Basis() = default;
  explicit Basis(Vec3f z_axis) : z(z_axis) {
    const float sign = std::copysign(1.0f, z.z);
    const float a = -1.0f / (sign + z.z), b = z.x * z.y * a;
    x = {1.0f + sign * z.x * z.x * a, sign * b, -sign * z.x};
    y = {b, sign + z.y * z.y * a, -z.y};
  }
  Vec3f to_local(Vec3f v) const { return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)}; }
  Vec3f to_world(Vec3f v) const { return v.x * x + v.y * y + v.z * z; }
  Vec3f x, y, z;
};

LIPPMANN_INLINE Vec2f sample_disc(Vec2f u) {
  const Vec2f p = 2.0f * u - Vec2f(1.0f);
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const float radius = wide ? p.x : p.y, across = wide ? p.y : p.x;
  const float turned = (kPi / 4) * (across / (radius == 0.0f ? 1.0f : radius));
  float sine, cosine;
  fast_sin_cos(wide ? turned : kPi / 2 - turned, sine, cosine);
  return {radius * cosine, radius * sine};
}

/// Samples the hemisphere z > 0 with a density of cosine / pi.
LIPPMANN_INLINE Vec3f sample_cosine(Vec2f u) {
  const Vec2f d = sample_disc(u);
  const float square = 1.0f - d.x * d.x - d.y * d.y;
  return {d.x, d.y, std::sqrt(square > 0.0f ? square : 0.0f)};
}

/// Samples a triangle uniformly. Returns the barycentric weights of its second and third corner.
Vec2f sample_triangle(Vec2f u);

/// Returns the weight of Veach's power heuristic (exponent 2), for one sample from each of two techniques. The densities may be
/// infinite.
inline float power_heuristic(float density, float other_density) {
  if (!(other_density > 0.0f)) return 1.0f;
  const float ratio = other_density / density;  // the square of a density could overflow
  return 1.0f / (1.0f + ratio * ratio);
}

}  // namespace lippmann
