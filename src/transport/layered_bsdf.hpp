// glTF 2.0's surfaces with what few of them have: sheen, gloss that is rougher one way than the other, thin films, diffuse
// light that comes through, thin walls of glass. The common ones are metal_rough_bsdf.hpp's, which these must not slow down.
//
// Based on: what metal_rough_bsdf.hpp is; Khronos Group, KHR_materials_sheen, _anisotropy, _iridescence,
// _diffuse_transmission, _volume (its thin walls). From above: clear coat, sheen, then gloss with its film over diffuse light.
// We deviate: 1. sheen and films pass the lesser of what they would let in from the light and out to the viewer, so that what
// lies below stays reciprocal; 2. of glass that is rougher one way, the light that met several facets is made up for as if it
// were as rough both ways as it looks from the viewer (alpha_towards).
#pragma once

#include <optional>

#include "transport/metal_rough_bsdf.hpp"
#include "transport/microfacet.hpp"
#include "transport/thin_film.hpp"

namespace lippmann {

/// At one point, textures looked up. Colours and shares in [0, 1].
struct LayeredSurface {
  MetalRoughSurface base;
  Vec3f sheen_color{0.0f};
  float sheen_roughness = 0.0f;
  float anisotropy = 0.0f;  ///< roughness along the tangent: alpha -> 1 with the square of it
  float film_share = 0.0f;  ///< how much of the surface has the film
  ThinFilm film;
  float diffuse_transmission = 0.0f;  ///< share of the diffuse light
  Vec3f diffuse_transmission_color{1.0f};
  bool is_thin = false;           ///< what transmits is a wall so thin that it bends nothing
  bool shadow_rays_pass = false;  ///< such a wall: what goes straight() on is known to light that is sampled beyond it
};

class LayeredBsdf {
 public:
  /// As MetalRoughBsdf, sheen and what transmits with the gloss's normal. tangent: along which it is rougher, not along the
  /// normal; of any length.
  LayeredBsdf(const LayeredSurface& surface, const GgxAlbedo& albedo, const MetalRoughBsdf::Normals& normals, Vec3f tangent,
              Vec3f view, bool entering);

  BsdfValue evaluate(Vec3f light) const;
  std::optional<BsdfSample> sample(float lobe, Vec2f u) const;

  /// The diffuse part that is reflected, as MetalRoughBsdf's.
  Vec3f diffuse_albedo() const { return below_coat_ * sheen_passes_ * gloss_passes_ * diffuse_color_; }
  Vec3f evaluate_diffuse(Vec3f light) const;
  Vec3f normal() const { return basis_.z; }
  /// What passes a smooth thin wall straight on, a Dirac lobe of sample(); 0 of all else.
  Vec3f straight() const;
  bool scatters_through() const { return glass_share_ > 0.0f || through_color_ != Vec3f(0.0f); }
  bool has_coat_apart() const;

 private:
  /// Probabilities of sample(); add up to 1 or are all 0.
  struct Shares {
    float diffuse = 0.0f, through = 0.0f, sheen = 0.0f, gloss = 0.0f, glass = 0.0f, coat = 0.0f;
  };
  /// What a facet of the glass sends where, and how probably sample() reflects.
  struct GlassFacet {
    Vec3f reflected, transmitted;
    float chance;
  };

  void set_gloss();
  void set_coat();
  void set_shares();

  Vec3f single_albedo(Vec3f direction) const;
  /// Film and bare surface mixed: the directional albedo with compensation, and the reflectance of one facet.
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
  Vec3f ahead_;             ///< from the viewer to the point and on
  Basis basis_;             ///< of the diffuse part; x along the tangent
  Basis gloss_basis_;       ///< of all else below the coat
  Basis coat_basis_;        ///< set where there is one
  bool glossy_apart_;       ///< the gloss has a basis of its own
  Vec3f view_, coat_view_;  ///< local to gloss_basis_ and coat_basis_
  bool is_smooth_;
  AnisotropicGgx ggx_;
  float coat_alpha_, eta_;
  float matt_, glass_share_;                         ///< shares: dielectric that scatters inside, dielectric that transmits
  Vec3f dielectric_f0_, dielectric_f90_;             ///< reflectance of the gloss above the diffuse part
  Vec3f diffuse_color_, through_color_;              ///< without anything above
  Vec3f gloss_passes_{1.0f}, diffuse_passes_{1.0f};  ///< what gets through the gloss to the viewer; on average
  Vec3f gloss_albedo_{0.0f}, gloss_compensation_{1.0f};
  float glass_compensation_ = 1.0f;
  float most_sheen_, sheen_passes_ = 1.0f;
  float below_coat_ = 1.0f;
  Shares shares_;
};

}  // namespace lippmann
