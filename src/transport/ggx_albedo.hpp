// Tables of the directional albedo of GGX surfaces over angle and roughness, to add the light that bounces between facets more
// than once.
//
// Based on: C. Kulla, A. Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017 course (the lost light
// returns as a series of bounces, each with the mean facet reflectance F); E. Turquin, "Practical multiple scattering
// compensation for microfacet models", 2019 (multiple scattering has the shape of the single-scattering lobe, so it is a factor
// on this lobe).
//
// At each further bounce, a fraction e of the light leaves the surface. The sum over all bounces is F e + F (1 - e) F e + ... =
// F e / (1 - F (1 - e)). The factor on the lobe is 1 + (1 - E) / E times this sum, where E is the albedo of single scattering
// for F = 1.
//
// We deviate in two numbers, which are fitted to simulated walks between facets (E. Heitz et al., "Multiple-Scattering
// Microfacet BSDFs with the Smith Model", SIGGRAPH 2016) for roughness 0.2 to 1:
// 1. e = 0.3 + 0.74 E instead of the mean of E over all directions.
// 2. F = F0 + (F90 - F0) w with w = 0.065 + 0.77 (1 - roughness) (1 - cosine) instead of w = 1 / 21. Light that grazes a
//    surface with low slopes also grazes the next facet.
//
// The albedos are within 1.2 % of the walks for F0 >= 0.2, and within 2.4 % for F0 = 0.04.
#pragma once

#include <cmath>

#include "lippmann/core/math.hpp"
#include "transport/brushed_albedo.hpp"
#include "transport/glass_albedo.hpp"
#include "transport/sheen.hpp"
#include "transport/table_place.hpp"

namespace lippmann {

/// With Schlick's reflectance F0 + (F90 - F0) (1 - cos)^5, every albedo is linear in F0 and F90. The tables hold the
/// coefficients of F0 and F90.
class GgxAlbedo {
 public:
  /// Computes the tables, which takes about 40 ms.
  GgxAlbedo();

  /// Returns (x, y, w). The albedo of single scattering is x F0 + y F90, and w is the weight of F90 at all facets after the
  /// first. `cosine` is the cosine between view and normal, in [0, 1].
  LIPPMANN_INLINE Vec3f single(float cosine, float alpha) const {
    const TablePlace r(std::sqrt(alpha), kSize), c(cosine, kSize);
    const int at = r.index * kSize + c.index;
    return {mixed(single_f0_, at, r.share, c.share), mixed(single_f90_, at, r.share, c.share),
            edge_of_later_facets(cosine, alpha)};
  }

  LIPPMANN_INLINE static float edge_of_later_facets(float cosine, float alpha) {
    return 0.065f + 0.77f * (1.0f - std::sqrt(alpha)) * (1.0f - cosine);
  }

  /// Returns the factor on single scattering that adds multiple scattering. A surface with F0 = F90 = 1 becomes lossless.
  static Vec3f compensation(Vec3f single, Vec3f f0, Vec3f f90) { return compensation_of(single, f0, f90); }

  static Vec3f directional(Vec3f single, Vec3f f0, Vec3f f90) {
    return are_grey(f0, f90) ? Vec3f(directional_of(single, f0.x, f90.x)) : directional_of(single, f0, f90);
  }
  /// Same as directional(), without branches. `Color` is a colour or the type of one channel.
  template <class Color>
  LIPPMANN_INLINE static Color directional_of(Vec3f single, Color f0, Color f90) {
    return (f0 * single.x + f90 * single.y) * compensation_of(single, f0, f90);
  }

  /// Returns the mean of directional() over the hemisphere, weighted by the cosine.
  LIPPMANN_INLINE Vec3f mean(float alpha, Vec3f f0, Vec3f f90) const {
    const TablePlace r(std::sqrt(alpha), kSize);
    const float edge = edge_of_later_facets(0.65f, alpha);  // most light is lost at cosines near 0.65
    const auto mixed = [&](int k) LIPPMANN_INLINE_LAMBDA {
      const float(&column)[kSize] = mean_[k];
      return column[r.index] * (1.0f - r.share) + column[r.index + 1] * r.share;
    };
    const float of_f0 = mixed(0), of_f90 = mixed(1);
    return f0 * of_f0 + f90 * of_f90 + of_more_bounces(of_f0 + of_f90, edge, f0, f90) * (f0 * mixed(2) + f90 * mixed(3));
  }

  const GlassAlbedo& glass() const { return glass_; }
  const BrushedAlbedo& brushed() const { return brushed_; }
  const SheenAlbedo& sheen() const { return sheen_; }

 private:
  static constexpr int kSize = 32;

  /// Grey surfaces, such as most dielectrics, need the divisions of directional_of() for one channel only.
  static bool are_grey(Vec3f f0, Vec3f f90) { return f0.x == f0.y && f0.x == f0.z && f90.x == f90.y && f90.x == f90.z; }

  /// Returns F e / (1 - F (1 - e)), the fraction of light that leaves after further bounces between facets. F is the facets'
  /// mean reflectance, and e the fraction that leaves at each bounce.
  template <class Color>
  LIPPMANN_INLINE static Color of_more_bounces(float all, float edge, Color f0, Color f90) {
    const Color facet = glm::min(f0 + (f90 - f0) * edge, Color(1.0f));
    const Color leaves = facet * (0.3f + 0.74f * all);
    return leaves / (Color(1.0f) - facet + leaves);
  }
  template <class Color>
  LIPPMANN_INLINE static Color compensation_of(Vec3f single, Color f0, Color f90) {
    const float all = single.x + single.y;
    return Color(1.0f) + of_more_bounces(all, single.z, f0, f90) * ((1.0f - all) / all);
  }

  LIPPMANN_INLINE static float mixed(const float (&table)[kSize * kSize], int at, float of_rougher, float of_next) {
    return (table[at] * (1.0f - of_next) + table[at + 1] * of_next) * (1.0f - of_rougher) +
           (table[at + kSize] * (1.0f - of_next) + table[at + kSize + 1] * of_next) * of_rougher;
  }

  // Plain arrays, because GCC 14 does not vectorise loops over std::array or vector members.
  float single_f0_[kSize * kSize], single_f90_[kSize * kSize];
  /// Means over the hemisphere, for each roughness: x, y, x (1 - E) / E and y (1 - E) / E. The albedo of single scattering is x
  /// F0 + y F90, and E is its value for F0 = F90 = 1.
  float mean_[4][kSize];
  GlassAlbedo glass_;
  BrushedAlbedo brushed_;
  SheenAlbedo sheen_;
};

}  // namespace lippmann
