// Microfacet surfaces: the GGX distribution, its masking, sampling of visible normals, and Fresnel reflectance. z points along
// the surface normal.
//
// Based on: B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007; E. Heitz, "Understanding
// the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014; J. Dupuy, A. Benyoub, "Sampling Visible GGX
// Normals with Spherical Caps", HPG 2023; C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", CGF 13(3),
// 1994.
#pragma once

#include "transport/fast_angles.hpp"

namespace lippmann {

/// Surfaces with a lower alpha (roughness^2) are mirrors, with Dirac lobes.
inline constexpr float kSmoothAlpha = 1e-3f;

/// An isotropic GGX distribution of facets. alpha must be >= kSmoothAlpha.
struct Ggx {
  float alpha = 1.0f;

  /// Returns the density of facet normals h, for h.z > 0. The integral of h.z times this density is 1.
  float distribution(Vec3f h) const {
    const float a2 = alpha * alpha;
    // 1 - cos^2 would have no precision at the peak of narrow lobes.
    const float d = a2 * h.z * h.z + h.x * h.x + h.y * h.y;
    return a2 / (kPi * d * d);
  }
  float masking(Vec3f v) const { return 1.0f / (1.0f + lambda(v)); }
  /// Smith's height-correlated masking and shadowing.
  float masking(Vec3f a, Vec3f b) const { return 1.0f / (1.0f + lambda(a) + lambda(b)); }
  LIPPMANN_INLINE Vec3f sample_visible(Vec3f v, Vec2f u) const;
  /// Returns the density of sample_visible().
  float visible_density(Vec3f v, Vec3f h) const { return masking(v) * std::max(0.0f, glm::dot(v, h)) * distribution(h) / v.z; }
  float lambda(Vec3f v) const {
    const float cosine2 = v.z * v.z, tangent2 = (cosine2 < 1.0f ? 1.0f - cosine2 : 0.0f) / cosine2;
    return 0.5f * (std::sqrt(1.0f + alpha * alpha * tangent2) - 1.0f);
  }
};

struct AnisotropicGgx {
  Vec2f alpha{1.0f};

  float distribution(Vec3f h) const {
    const float d = squared(h.x / alpha.x) + squared(h.y / alpha.y) + h.z * h.z;
    return 1.0f / (kPi * alpha.x * alpha.y * d * d);
  }
  float masking(Vec3f v) const { return 1.0f / (1.0f + lambda(v)); }
  float masking(Vec3f a, Vec3f b) const { return 1.0f / (1.0f + lambda(a) + lambda(b)); }
  LIPPMANN_INLINE Vec3f sample_visible(Vec3f v, Vec2f u) const {
    const Vec3f stretched = glm::normalize(Vec3f(alpha.x * v.x, alpha.y * v.y, v.z));
    // The normal is the half vector of the view and a uniform point on the spherical cap of mirror directions.
    const float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z, square = 1.0f - z * z;
    const float radius = std::sqrt(square > 0.0f ? square : 0.0f);
    float sine, cosine;
    fast_sin_cos(2.0f * kPi * u.x, sine, cosine);
    const float up = z + stretched.z;
    return glm::normalize(
        Vec3f(alpha.x * (radius * cosine + stretched.x), alpha.y * (radius * sine + stretched.y), up > 1e-7f ? up : 1e-7f));
  }
  float visible_density(Vec3f v, Vec3f h) const {
    return masking(v) * std::max(0.0f, glm::dot(v, h)) * distribution(h) / std::abs(v.z);
  }
  float lambda(Vec3f v) const {
    return 0.5f * (std::sqrt(1.0f + (squared(alpha.x * v.x) + squared(alpha.y * v.y)) / squared(v.z)) - 1.0f);
  }
  /// Returns the alpha of the isotropic surface whose albedo for the unit direction v is closest.
  float alpha_towards(Vec3f v) const {
    return std::sqrt(squared(alpha.x * v.x) + squared(alpha.y * v.y) + alpha.x * alpha.y * squared(v.z));
  }
};

inline Vec3f Ggx::sample_visible(Vec3f v, Vec2f u) const { return AnisotropicGgx{Vec2f(alpha)}.sample_visible(v, u); }

LIPPMANN_INLINE float schlick_weight(float cosine) {
  const float rest = 1.0f - cosine, above = rest > 0.0f ? rest : 0.0f, m = above < 1.0f ? above : 1.0f, square = m * m;
  return square * square * m;
}

/// Returns the unpolarised reflectance between two dielectrics by Fresnel's equations, or 1 at total reflection. eta =
/// n_transmitted / n_incident.
LIPPMANN_INLINE float fresnel_dielectric(float cosine_incident, float eta) {
  const float above = cosine_incident > 0.0f ? cosine_incident : 0.0f, ci = above < 1.0f ? above : 1.0f;
  const float cosine2 = 1.0f - (1.0f - ci * ci) / squared(eta), ct = std::sqrt(cosine2 > 0.0f ? cosine2 : 0.0f);
  const float parallel = (eta * ci - ct) / (eta * ci + ct), perpendicular = (ci - eta * ct) / (ci + eta * ct);
  return cosine2 > 0.0f ? 0.5f * (squared(parallel) + squared(perpendicular)) : 1.0f;
}

/// Returns the reflectance of a dielectric in air at normal incidence.
inline float normal_reflectance(float ior) {
  const float r = (ior - 1.0f) / (ior + 1.0f);
  return r * r;
}

}  // namespace lippmann
