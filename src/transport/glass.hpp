// The transmissive part of glTF's surface, smooth or rough. The formulas have no branches, so that vectorised loops
// (shading/metal_rough_lanes.hpp) give the same bits as single points.
//
// Based on: B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007.
#pragma once

#include "transport/bsdf.hpp"
#include "transport/microfacet.hpp"

namespace lippmann {

/// Glass at one point. `here` is the medium on the viewer's side, and `beyond` the medium on the other side.
struct Glass {
  Vec3f tint{0.0f};
  float share = 0.0f;
  float eta = 1.0f;  ///< n_beyond / n_here, the ratio of the indices of refraction
  float compensation = 1.0f;
};

/// Returns the weight with which sample() chooses the glass. Reflected light has no tint, so the tint's luminance counts as at
/// least 0.1.
LIPPMANN_INLINE float glass_chance(const Glass& glass) {
  const float light = luminance(glass.tint);
  return glass.share * (light > 0.1f ? light : 0.1f);
}

/// Returns the BSDF of rough glass times |cosine|. Sets `density` to the probability density of sample_visible() followed by
/// draw_glass(). Both directions are unit vectors relative to the normal, with view.z > 0.
LIPPMANN_INLINE Vec3f glass_cosine_f(const Glass& glass, float alpha, Vec3f view, Vec3f light, float& density) {
  const Ggx ggx{alpha};
  const bool reflected = light.z > 0.0f;
  // The half vector is view + light for reflection and -(view + eta light) for refraction. The facet normal h is the half
  // vector on the viewer's side.
  const Vec3f half = glm::normalize(view + (reflected ? 1.0f : glass.eta) * light), h = (half.z < 0.0f ? -1.0f : 1.0f) * half;
  const float cosine = glm::dot(view, h), beyond = glm::dot(light, h);
  const float fresnel = fresnel_dielectric(cosine, glass.eta);
  const float hidden = ggx.lambda(view), hidden_from_light = ggx.lambda(light);
  const float visible = cosine * ggx.distribution(h) / ((1.0f + hidden) * view.z);
  const bool is_any = (cosine > 0.0f) & (light.z != 0.0f) & (reflected | (beyond < 0.0f));
  const float of_mirrors = fresnel * visible / (4.0f * cosine);
  const float of_lenses = (1.0f - fresnel) * visible * squared(glass.eta) * -beyond / squared(cosine + glass.eta * beyond);
  density = is_any ? reflected ? of_mirrors : of_lenses : 0.0f;
  const float passes = reflected ? (1.0f + hidden) / (1.0f + hidden + hidden_from_light) : 1.0f / (1.0f + hidden_from_light);
  const float all = density * passes * glass.compensation * glass.share;
  return {(reflected ? 1.0f : glass.tint.x) * all, (reflected ? 1.0f : glass.tint.y) * all,
          (reflected ? 1.0f : glass.tint.z) * all};
}

/// Returns the direction of light that a facet reflects or refracts to `view`. `decision` in [0, 1) selects reflection with
/// Fresnel's probability. Sets `outward` to a positive value unless the direction points into the
/// surface.
LIPPMANN_INLINE Vec3f draw_glass(float eta, Vec3f view, Vec3f facet, float decision, bool& transmitted, float& outward) {
  transmitted = decision >= fresnel_dielectric(glm::dot(view, facet), eta);
  const Vec3f refracted = refracted_away(view, facet, eta), reflected = mirrored(view, facet);
  const Vec3f light(transmitted ? refracted.x : reflected.x, transmitted ? refracted.y : reflected.y,
                    transmitted ? refracted.z : reflected.z);
  outward = (transmitted ? -1.0f : 1.0f) * light.z;
  return light;
}

}  // namespace lippmann
