// How much light a GGX surface sends back in all: tables over angle and roughness, and what they are for, making up for the
// light that bounces between facets more than once.
//
// Based on: C. Kulla, A. Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017 course (what is lost comes
// back as a series of bounces, each with the facets' mean reflectance F); E. Turquin, "Practical multiple scattering
// compensation for microfacet models", 2019 (it has the shape of the lobe of one scattering: a factor).
//
// Of what is left between the facets, a share e leaves with each further bounce: F e + F (1 - e) F e + ... = F e / (1 - F (1 -
// e)). The factor is 1 + (1 - E) / E of that, E the albedo of one scattering where F = 1.
//
// We deviate: e = 0.25 + 0.95 E in place of the mean of E, fitted to walks from facet to facet (E. Heitz et al.,
// "Multiple-Scattering Microfacet BSDFs with the Smith Model", SIGGRAPH 2016). Albedos are within 4 % of theirs, and within 1 %
// where one looks straight at the surface; Turquin's F0 in place of the series is 16 % too bright for roughness 1, F0 = 0.5.
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
  static Vec3f compensation(Vec2f single, Vec3f f0, Vec3f f90) {
    const float all = single.x + single.y;
    return Vec3f(1.0f) + of_more_bounces(all, f0, f90) * ((1.0f - all) / all);
  }

  /// Directional albedo with compensation.
  static Vec3f directional(Vec2f single, Vec3f f0, Vec3f f90) {
    return (f0 * single.x + f90 * single.y) * compensation(single, f0, f90);
  }

  /// The mean of directional() over the hemisphere, weighted by the cosine.
  Vec3f mean(float alpha, Vec3f f0, Vec3f f90) const;

  /// The like of single() for rough glass.
  const GlassAlbedo& glass() const { return glass_; }
  /// And for gloss that is rougher one way, and for sheen.
  const BrushedAlbedo& brushed() const { return brushed_; }
  const SheenAlbedo& sheen() const { return sheen_; }

 private:
  /// The share that comes back of light that has met white facets and not left them: F e / (1 - F (1 - e)).
  static Vec3f of_more_bounces(float all, Vec3f f0, Vec3f f90) {
    const Vec3f facet = glm::min(glm::mix(f0, f90, 1.0f / 21.0f), Vec3f(1.0f));  // Schlick's, weighted by the cosine
    const Vec3f leaves = facet * (0.25f + 0.95f * all);
    return leaves / (Vec3f(1.0f) - facet + leaves);
  }

  static constexpr int kSize = 32;  ///< entries along each side; cosines from 0 to 1, roughness = sqrt(alpha) from 0 to 1
  std::array<std::array<Vec2f, kSize>, kSize> single_;  ///< [roughness][cosine]
  std::array<Vec4f, kSize> mean_;  ///< by roughness: means of single_.x, single_.y, and of both times (1 - E) / E
  GlassAlbedo glass_;
  BrushedAlbedo brushed_;
  SheenAlbedo sheen_;
};

}  // namespace lippmann
