// How much light a GGX surface sends back in all: tables over angle and roughness, and what they are for, making up for the
// light that bounces between facets more than once.
//
// Based on: C. Kulla, A. Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017 course; E. Turquin,
// "Practical multiple scattering compensation for microfacet models", 2019 (the factor 1 + F0 (1 - E) / E).
#pragma once

#include <array>

#include "lippmann/core/math.hpp"
#include "transport/brushed_albedo.hpp"
#include "transport/glass_albedo.hpp"
#include "transport/sheen.hpp"

namespace lippmann {

/// With Schlick's reflectance F0 + (F90 - F0) (1 - cos)^5 every albedo is linear in F0 and F90; the tables hold the parts.
class GgxAlbedo {
 public:
  /// Integrates them: some 40 ms.
  GgxAlbedo();

  /// Directional albedo of one scattering: F0 = 1, F90 = 0 in x; F0 = 0, F90 = 1 in y. cosine: between the view and the normal,
  /// in [0, 1].
  Vec2f single(float cosine, float alpha) const;

  /// By how much reflected light is multiplied, so that F0 = F90 = 1 loses none.
  static Vec3f compensation(Vec2f single, Vec3f f0) {
    const float all = single.x + single.y;
    return Vec3f(1.0f) + f0 * ((1.0f - all) / all);
  }

  /// Directional albedo with compensation.
  static Vec3f directional(Vec2f single, Vec3f f0, Vec3f f90) {
    return (f0 * single.x + f90 * single.y) * compensation(single, f0);
  }

  /// The mean of directional() over the hemisphere, weighted by the cosine.
  Vec3f mean(float alpha, Vec3f f0, Vec3f f90) const;

  /// The like of single() for rough glass.
  const GlassAlbedo& glass() const { return glass_; }
  /// And for gloss that is rougher one way, and for sheen.
  const BrushedAlbedo& brushed() const { return brushed_; }
  const SheenAlbedo& sheen() const { return sheen_; }

 private:
  static constexpr int kSize = 32;  ///< entries along each side; cosines from 0 to 1, roughness = sqrt(alpha) from 0 to 1
  std::array<std::array<Vec2f, kSize>, kSize> single_;  ///< [roughness][cosine]
  std::array<Vec4f, kSize> mean_;  ///< by roughness: means of single_.x, single_.y, and of both times (1 - E) / E
  GlassAlbedo glass_;
  BrushedAlbedo brushed_;
  SheenAlbedo sheen_;
};

}  // namespace lippmann
