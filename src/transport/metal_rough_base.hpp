// The base of glTF's metallic-roughness surface, diffuse light under a dielectric gloss or metal, as formulas without branches:
// they serve one point (metal_rough_bsdf.hpp) and, in loops that the compiler makes wide, sixteen
// (shading/metal_rough_lanes.hpp), to the same bits.
//
// Based on: what metal_rough_bsdf.hpp is.
#pragma once

#include "transport/bsdf.hpp"
#include "transport/ggx_albedo.hpp"
#include "transport/microfacet.hpp"

namespace lippmann {

/// At one point, textures looked up. Colours in [0, 1].
struct MetalRoughSurface {
  Vec3f base_color{1.0f};
  float metallic = 1.0f, roughness = 1.0f;
  float ior = 1.5f;
  float specular = 1.0f;
  Vec3f specular_color{1.0f};
  float transmission = 0.0f;
  float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
};

/// The base at one point, seen from one direction. Directions are local to the gloss's basis, but for those of diffuse light.
struct MetalRoughBase {
  Vec3f view;  ///< unit, towards the viewer
  float alpha;
  Vec3f diffuse_color;                       ///< albedo, the gloss's share taken out
  Vec3f diffuse_passes;                      ///< share of diffuse light that the gloss lets in
  Vec3f dielectric_f0, gloss_f0;             ///< reflectance of the gloss above the diffuse part; of it and of metal, weighted
  float dielectric_f90, gloss_f90;           ///< likewise, where it is grazed
  Vec3f gloss_compensation, gloss_albedo;    ///< for light that met more than one facet; with it
  float diffuse_luminance, gloss_luminance;  ///< of white light from all around, what both send to the viewer

  bool is_smooth() const { return alpha < kSmoothAlpha; }
};

/// Grazing views have no digits left for masking.
LIPPMANN_INLINE Vec3f lifted_view(Vec3f local) {
  constexpr float kLeastCosine = 1e-4f;
  const float z = local.z >= kLeastCosine ? local.z : kLeastCosine;
  const float scale = local.z >= kLeastCosine ? 1.0f : 1.0f / std::sqrt(local.x * local.x + local.y * local.y + z * z);
  return {local.x * scale, local.y * scale, z * scale};
}

/// GgxAlbedo::single() of facets that are rough, or of a mirror.
LIPPMANN_INLINE Vec3f single_albedo(const GgxAlbedo& albedo, float cosine, float alpha) {
  const Vec3f rough = albedo.single(cosine, alpha);
  const float edge = schlick_weight(cosine);
  const bool smooth = alpha < kSmoothAlpha;
  return {smooth ? 1.0f - edge : rough.x, smooth ? edge : rough.y, smooth ? 0.0f : rough.z};
}

/// view: as MetalRoughBase::view, from lifted_view().
LIPPMANN_INLINE MetalRoughBase metal_rough_base(const MetalRoughSurface& s, const GgxAlbedo& albedo, Vec3f view) {
  MetalRoughBase b;
  b.view = view;
  b.alpha = squared(s.roughness);
  const float dielectric = (1.0f - s.metallic) * (1.0f - s.transmission);
  b.dielectric_f0 = glm::min(normal_reflectance(s.ior) * s.specular_color, Vec3f(1.0f)) * s.specular;
  b.dielectric_f90 = s.specular;
  b.gloss_f0 = dielectric * b.dielectric_f0 + s.metallic * s.base_color;
  b.gloss_f90 = dielectric * b.dielectric_f90 + s.metallic;

  // Each part's own compensation: of the dielectric and of the metal. Their sum is carried by one lobe; its factor is the
  // mean, weighted by what they send.
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

/// The share of light from the angle of `cosine` to the diffuse part's normal that the gloss lets in, per channel.
LIPPMANN_INLINE Vec3f let_in(const MetalRoughBase& b, const GgxAlbedo& albedo, float cosine) {
  return Vec3f(1.0f) -
         GgxAlbedo::directional_of(single_albedo(albedo, cosine, b.alpha), b.dielectric_f0, Vec3f(b.dielectric_f90));
}

/// Kelemen and Szirmay-Kalos: what the gloss lets in on the way from the light and out on the way to the viewer (the latter,
/// and the normalisation, are in diffuse_color), times the cosine.
LIPPMANN_INLINE Vec3f diffuse_cosine_f(const MetalRoughBase& b, const GgxAlbedo& albedo, float cosine) {
  return b.diffuse_color * let_in(b, albedo, cosine) * (cosine * (1.0f / kPi));
}

/// What a rough gloss sends to the viewer from `light`, z > 0, times the cosine; and the density of drawing it, which is
/// Ggx::visible_density's, of whose parts the value has most.
LIPPMANN_INLINE Vec3f gloss_cosine_f(const MetalRoughBase& b, Vec3f light, float& density) {
  const Ggx ggx{b.alpha};
  const Vec3f h = glm::normalize(b.view + light);
  const float cosine = glm::dot(b.view, h), facets = ggx.distribution(h), hidden = ggx.lambda(b.view);
  const Vec3f fresnel = b.gloss_f0 + (Vec3f(b.gloss_f90) - b.gloss_f0) * schlick_weight(cosine);
  const float seen_from_both = 1.0f / (1.0f + hidden + ggx.lambda(light)), seen = 1.0f / (1.0f + hidden);
  density = seen * facets / (4.0f * b.view.z);
  return fresnel * b.gloss_compensation * (facets * seen_from_both / (4.0f * b.view.z));
}

/// The normal of a facet that the viewer sees, of a rough or smooth surface: mirrored(), it is a direction in which the gloss
/// sends light, below the surface where that takes it.
LIPPMANN_INLINE Vec3f draw_facet(const MetalRoughBase& b, Vec2f u) {
  const Vec3f facet = Ggx{b.alpha}.sample_visible(b.view, u);
  const bool smooth = b.is_smooth();
  return {smooth ? 0.0f : facet.x, smooth ? 0.0f : facet.y, smooth ? 1.0f : facet.z};
}

}  // namespace lippmann
