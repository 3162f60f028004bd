// The base of glTF's metallic-roughness surface: a diffuse part under a dielectric gloss, or metal. The formulas have no
// branches, so that vectorised loops (shading/metal_rough_lanes.hpp) give the same bits as single points.
//
// Based on: the references of metal_rough_bsdf.hpp.
#pragma once

#include "transport/bsdf.hpp"
#include "transport/ggx_albedo.hpp"
#include "transport/microfacet.hpp"

namespace lippmann {

struct MetalRoughSurface {
  Vec3f base_color{1.0f};
  float metallic = 1.0f, roughness = 1.0f;
  float ior = 1.5f;
  float specular = 1.0f;
  Vec3f specular_color{1.0f};
  float transmission = 0.0f;
  float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
};

/// The surface at one point, for one viewing direction. Directions of diffuse light are relative to the diffuse part's normal,
/// and all other directions to the gloss's normal.
struct MetalRoughBase {
  Vec3f view;
  float alpha;
  Vec3f diffuse_color;   ///< albedo * (transmittance of the gloss to the viewer) / diffuse_passes
  Vec3f diffuse_passes;  ///< fraction of light that passes the gloss, as the cosine-weighted mean over all directions
  /// Reflectance at normal incidence: dielectric_f0 of the dielectric, gloss_f0 of the mix with metal.
  Vec3f dielectric_f0, gloss_f0;
  float dielectric_f90, gloss_f90;  ///< reflectance at grazing incidence, of the dielectric and of the mix with metal
  Vec3f gloss_compensation, gloss_albedo;
  float diffuse_luminance, gloss_luminance;  ///< luminance of each part for the viewer under uniform white light

  bool is_smooth() const { return alpha < kSmoothAlpha; }
};

LIPPMANN_INLINE Vec3f lifted_view(Vec3f local) {
  constexpr float kLeastCosine = 1e-4f;
  const float z = local.z >= kLeastCosine ? local.z : kLeastCosine;
  const float scale = local.z >= kLeastCosine ? 1.0f : 1.0f / std::sqrt(local.x * local.x + local.y * local.y + z * z);
  return {local.x * scale, local.y * scale, z * scale};
}

/// Returns GgxAlbedo::single() for rough surfaces, or its limit for mirrors.
LIPPMANN_INLINE Vec3f single_albedo(const GgxAlbedo& albedo, float cosine, float alpha) {
  const Vec3f rough = albedo.single(cosine, alpha);
  const float edge = schlick_weight(cosine);
  const bool smooth = alpha < kSmoothAlpha;
  return {smooth ? 1.0f - edge : rough.x, smooth ? edge : rough.y, smooth ? 0.0f : rough.z};
}

/// `view` must be a result of lifted_view().
LIPPMANN_INLINE MetalRoughBase metal_rough_base(const MetalRoughSurface& s, const GgxAlbedo& albedo, Vec3f view) {
  MetalRoughBase b;
  b.view = view;
  b.alpha = squared(s.roughness);
  const float dielectric = (1.0f - s.metallic) * (1.0f - s.transmission);
  b.dielectric_f0 = glm::min(normal_reflectance(s.ior) * s.specular_color, Vec3f(1.0f)) * s.specular;
  b.dielectric_f90 = s.specular;
  b.gloss_f0 = dielectric * b.dielectric_f0 + s.metallic * s.base_color;
  b.gloss_f90 = dielectric * b.dielectric_f90 + s.metallic;

  // The dielectric and the metal share one reflecting lobe. Its factor for multiple scattering is the mean of the two
  // materials' factors, weighted by the light that each material reflects.
  const Vec3f single = single_albedo(albedo, view.z, b.alpha);
  const Vec3f of_dielectric = GgxAlbedo::directional_of(single, b.dielectric_f0, Vec3f(b.dielectric_f90));
  b.gloss_albedo = dielectric * of_dielectric + s.metallic * GgxAlbedo::directional_of(single, s.base_color, Vec3f(1.0f));
  const Vec3f once = b.gloss_f0 * single.x + Vec3f(b.gloss_f90 * single.y);
  const auto compensation = [](float all, float one) LIPPMANN_INLINE_LAMBDA { return one > 0.0f ? all / one : 1.0f; };
  b.gloss_compensation = {compensation(b.gloss_albedo.x, once.x), compensation(b.gloss_albedo.y, once.y),
                          compensation(b.gloss_albedo.z, once.z)};

  const Vec3f f90(b.dielectric_f90);
  const Vec3f of_mirror = b.dielectric_f0 * (20.0f / 21.0f) + f90 * (1.0f / 21.0f);
  const Vec3f of_facets = albedo.mean(b.alpha, b.dielectric_f0, f90);
  const Vec3f mean(b.is_smooth() ? of_mirror.x : of_facets.x, b.is_smooth() ? of_mirror.y : of_facets.y,
                   b.is_smooth() ? of_mirror.z : of_facets.z);
  b.diffuse_passes = glm::max(Vec3f(1.0f) - mean, Vec3f(1e-3f));
  const Vec3f below = dielectric * s.base_color * (Vec3f(1.0f) - of_dielectric);
  b.diffuse_color = below / b.diffuse_passes;
  b.diffuse_luminance = luminance(below), b.gloss_luminance = luminance(b.gloss_albedo);
  return b;
}

/// Returns the fraction of light that passes the gloss to the diffuse part. `cosine` is the cosine between light and the
/// diffuse part's normal.
LIPPMANN_INLINE Vec3f let_in(const MetalRoughBase& b, const GgxAlbedo& albedo, float cosine) {
  return Vec3f(1.0f) -
         GgxAlbedo::directional_of(single_albedo(albedo, cosine, b.alpha), b.dielectric_f0, Vec3f(b.dielectric_f90));
}

/// Returns the diffuse BRDF times the cosine, after Kelemen and Szirmay-Kalos: the albedo, times the fractions of light that
/// the gloss lets in and lets out. diffuse_color includes the fraction towards the viewer.
LIPPMANN_INLINE Vec3f diffuse_cosine_f(const MetalRoughBase& b, const GgxAlbedo& albedo, float cosine) {
  return b.diffuse_color * let_in(b, albedo, cosine) * (cosine * (1.0f / kPi));
}

/// Returns the BRDF of a rough gloss times the cosine, for light.z > 0. Also computes `density`, the probability density of
/// light directions that are sampled by draw_facet().
LIPPMANN_INLINE Vec3f gloss_cosine_f(const MetalRoughBase& b, Vec3f light, float& density) {
  const Ggx ggx{b.alpha};
  const Vec3f h = glm::normalize(b.view + light);
  const float cosine = glm::dot(b.view, h), facets = ggx.distribution(h), hidden = ggx.lambda(b.view);
  const Vec3f fresnel = b.gloss_f0 + (Vec3f(b.gloss_f90) - b.gloss_f0) * schlick_weight(cosine);
  const float seen_from_both = 1.0f / (1.0f + hidden + ggx.lambda(light)), seen = 1.0f / (1.0f + hidden);
  density = seen * facets / (4.0f * b.view.z);
  return fresnel * b.gloss_compensation * (facets * seen_from_both / (4.0f * b.view.z));
}

/// Samples the normal of a facet visible to the viewer. mirrored() about this normal gives a light direction, which may lie
/// below the surface.
LIPPMANN_INLINE Vec3f draw_facet(const MetalRoughBase& b, Vec2f u) {
  const Vec3f facet = Ggx{b.alpha}.sample_visible(b.view, u);
  const bool smooth = b.is_smooth();
  return {smooth ? 0.0f : facet.x, smooth ? 0.0f : facet.y, smooth ? 1.0f : facet.z};
}

}  // namespace lippmann
