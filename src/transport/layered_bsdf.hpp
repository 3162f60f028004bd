// glTF 2.0 surfaces with sheen, anisotropic gloss, thin films, diffuse transmission, or thin walls of glass. Other surfaces use
// metal_rough_bsdf.hpp, which is faster.
//
// Based on: the references of metal_rough_bsdf.hpp; Khronos Group, KHR_materials_sheen, _anisotropy, _iridescence,
// _diffuse_transmission, _volume (thin walls).
//
// The layers, from top to bottom: clear coat; sheen; gloss with its film; diffuse part.
//
// We deviate:
// 1. Sheen and films transmit one fraction for the light's direction and one for the view. The layers below are scaled by the
//    smaller fraction, so that the layers stay reciprocal.
// 2. The compensation for multiple scattering in anisotropic glass uses the isotropic roughness that the viewer sees
//    (alpha_towards).
#pragma once

#include <optional>

#include "transport/metal_rough_bsdf.hpp"
#include "transport/microfacet.hpp"
#include "transport/thin_film.hpp"

namespace lippmann {

/// Surface parameters at one point, with textures applied. Colours and weights are in [0, 1].
struct LayeredSurface {
  MetalRoughSurface base;
  Vec3f sheen_color{0.0f};
  float sheen_roughness = 0.0f;
  float anisotropy = 0.0f;
  float film_share = 0.0f;
  ThinFilm film;
  float diffuse_transmission = 0.0f;
  Vec3f diffuse_transmission_color{1.0f};
  bool is_thin = false;
  bool shadow_rays_pass = false;  ///< whether shadow rays pass the thin wall; if so, passing straight through is no path vertex
};

class LayeredBsdf {
 public:
  /// The arguments are as for MetalRoughBsdf, except for `tangent`: the direction of greater roughness. It may have any length,
  /// but must not be parallel to the normal.
  LayeredBsdf(const LayeredSurface& surface, const GgxAlbedo& albedo, const MetalRoughBsdf::Normals& normals, Vec3f tangent,
              Vec3f view, bool entering);

  BsdfValue evaluate(Vec3f light) const;
  std::optional<BsdfSample> sample(float lobe, Vec2f u) const;

  Vec3f diffuse_albedo() const { return below_coat_ * sheen_passes_ * gloss_passes_ * diffuse_color_; }
  Vec3f evaluate_diffuse(Vec3f light) const;
  Vec3f normal() const { return basis_.z; }
  /// Returns the transmittance of a smooth thin wall, which is a Dirac lobe of sample(). Other surfaces return 0.
  Vec3f straight() const;
  bool scatters_through() const { return glass_share_ > 0.0f || through_color_ != Vec3f(0.0f); }
  bool has_coat_apart() const;

 private:
  /// Probabilities with which sample() chooses a layer. They add up to 1 or are all 0.
  struct Shares {
    float diffuse = 0.0f, through = 0.0f, sheen = 0.0f, gloss = 0.0f, glass = 0.0f, coat = 0.0f;
  };
  struct GlassFacet {
    Vec3f reflected, transmitted;
    float chance;
  };

  void set_gloss();
  void set_coat();
  void set_shares();

  Vec3f single_albedo(Vec3f direction) const;
  /// albedo_of() returns the directional albedo with multiple scattering, and fresnel_of() the reflectance of one facet. Both
  /// are averaged over the parts of the surface with and without the film.
  Vec3f albedo_of(Vec3f f0, Vec3f f90, Vec3f direction) const;
  Vec3f fresnel_of(Vec3f f0, Vec3f f90, float cosine) const;
  Vec3f passes_gloss(Vec3f direction) const;
  Vec3f below_gloss(Vec3f light) const;
  float passes_sheen(float cosine) const;
  float below_sheen(Vec3f light) const;
  GlassFacet glass_facet(float cosine) const;

  Vec3f local_to_gloss(Vec3f world, Vec3f local) const { return glossy_apart_ ? gloss_basis_.to_local(world) : local; }
  void add_diffuse(Vec3f light, BsdfValue& value) const;
  void add_gloss(Vec3f light, BsdfValue& value) const;
  void add_glass(Vec3f light, BsdfValue& value) const;
  void add_sheen(Vec3f light, BsdfValue& value) const;
  void add_coat(Vec3f light, BsdfValue& value) const;
  bool draw(float lobe, Vec2f u, BsdfSample& s) const;
  bool draw_gloss(Vec2f u, BsdfSample& s) const;
  bool draw_glass(float decision, Vec2f u, BsdfSample& s) const;
  bool pass_straight(float chance, BsdfSample& s) const;
  bool draw_coat(Vec2f u, BsdfSample& s) const;

  LayeredSurface surface_;
  const GgxAlbedo& albedo_;
  Vec3f ahead_;
  Basis basis_;
  Basis gloss_basis_;
  Basis coat_basis_;
  bool glossy_apart_;
  Vec3f view_, coat_view_;
  bool is_smooth_;
  AnisotropicGgx ggx_;
  float coat_alpha_, eta_;
  float matt_, glass_share_;
  /// Reflectance of the gloss above the diffuse part, at normal incidence and at grazing incidence.
  Vec3f dielectric_f0_, dielectric_f90_;
  Vec3f diffuse_color_, through_color_;
  /// Fraction of light that passes the gloss: towards the viewer, and as the mean over all directions.
  Vec3f gloss_passes_{1.0f}, diffuse_passes_{1.0f};
  Vec3f gloss_albedo_{0.0f}, gloss_compensation_{1.0f};
  float glass_compensation_ = 1.0f;
  float most_sheen_, sheen_passes_ = 1.0f;
  float below_coat_ = 1.0f;
  Shares shares_;
};

}  // namespace lippmann
