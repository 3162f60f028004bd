#pragma once

#include "lippmann/core/math.hpp"
#include "transport/sampling.hpp"

namespace lippmann {

struct BsdfValue {
  Vec3f cosine_f{0.0f};  ///< BSDF times |cosine of the angle to the shading normal|
  float density = 0.0f;
  bool transmitted = false;
};

struct BsdfSample {
  Vec3f direction{0.0f};
  Vec3f weight{0.0f};  ///< cosine_f / density; for a Dirac lobe, its reflectance divided by its probability
  float density = 0.0f;
  bool transmitted = false;
  bool straight = false;  ///< the light continues straight through the surface
  bool is_vertex = true;  ///< false: the surface is passed straight and does not count as a path vertex
  bool is_delta() const { return density == kInfinity; }
};

/// Returns the mirror direction of v about n. Both point away from the surface.
LIPPMANN_INLINE Vec3f mirrored(Vec3f v, Vec3f n) { return 2.0f * glm::dot(v, n) * n - v; }

/// Returns the refracted direction by Snell's law, or the null vector at total reflection. Like v, it points away from the
/// surface. n lies on v's side. eta = n_beyond / n_here.
LIPPMANN_INLINE Vec3f refracted_away(Vec3f v, Vec3f n, float eta) {
  const float cosine = glm::dot(v, n), k = 1.0f - (1.0f - cosine * cosine) / (eta * eta);
  const bool passes = k > 0.0f;
  const Vec3f away = glm::normalize((cosine / eta - std::sqrt(passes ? k : 0.0f)) * n - v / eta);
  return {passes ? away.x : 0.0f, passes ? away.y : 0.0f, passes ? away.z : 0.0f};
}

inline float luminance(Vec3f c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

}  // namespace lippmann
