// What both kinds of surface answer: how much light goes from one direction to another, and a direction worth following.
#pragma once

#include "lippmann/core/math.hpp"
#include "transport/sampling.hpp"

namespace lippmann {

struct BsdfValue {
  Vec3f cosine_f{0.0f};      ///< BSDF times |cosine| to the shading normal, per steradian
  float density = 0.0f;      ///< the density with which sample() draws that direction, per steradian
  bool transmitted = false;  ///< the direction lies behind the surface
};

struct BsdfSample {
  Vec3f direction{0.0f};
  Vec3f weight{0.0f};        ///< cosine_f / density; for Dirac's lobes, their share over their probability
  float density = 0.0f;      ///< per steradian; kInfinity: drawn from a Dirac lobe
  bool transmitted = false;  ///< goes on behind the surface
  bool straight = false;     ///< goes on as if nothing were there
  bool is_vertex = true;     ///< false: what goes straight on does not count among a path's vertices
  bool is_delta() const { return density == kInfinity; }
};

/// The mirror direction of v (both point away from the surface) about n.
LIPPMANN_INLINE Vec3f mirrored(Vec3f v, Vec3f n) { return 2.0f * glm::dot(v, n) * n - v; }

/// Snell's law: where the light comes from that leaves along v (away from the surface); n on v's side, eta =
/// n_beyond / n_here. The null vector at total reflection.
LIPPMANN_INLINE Vec3f refracted_away(Vec3f v, Vec3f n, float eta) {
  const float cosine = glm::dot(v, n), k = 1.0f - (1.0f - cosine * cosine) / (eta * eta);
  const bool passes = k > 0.0f;
  const Vec3f away = glm::normalize((cosine / eta - std::sqrt(passes ? k : 0.0f)) * n - v / eta);
  return {passes ? away.x : 0.0f, passes ? away.y : 0.0f, passes ? away.z : 0.0f};
}

inline float luminance(Vec3f c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

}  // namespace lippmann
