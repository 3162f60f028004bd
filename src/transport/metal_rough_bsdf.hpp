// glTF 2.0's metallic-roughness surface as a BSDF: a diffuse part under a dielectric gloss, or metal; glass if the surface
// transmits; and a clear coat.
//
// Based on: Khronos Group, "glTF 2.0 Specification", 2021, appendix B; KHR_materials_specular, _ior, _transmission, _clearcoat;
// C. Kelemen, L. Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model", Eurographics 2001 (diffuse part and
// gloss lose no light together); B. Walter et al., EGSR 2007 (rough glass, with compensation for multiple scattering as in
// glass_albedo.hpp).
//
// The compression of radiance inside glass is left out, because it is undone where the light leaves the glass.
#pragma once

#include <optional>

#include "transport/glass.hpp"
#include "transport/metal_rough_base.hpp"

namespace lippmann {

class MetalRoughBsdf {
 public:
  /// The unit normals of the layers, on the viewer's side. The angle between the gloss's normal and the view must be below 90
  /// degrees.
  struct Normals {
    Vec3f diffuse, gloss, coat{0.0f};
  };
  MetalRoughBsdf(const MetalRoughSurface& surface, const GgxAlbedo& albedo, const Normals& normals, Vec3f view, bool entering);
  MetalRoughBsdf(const MetalRoughSurface& surface, const GgxAlbedo& albedo, Vec3f normal, Vec3f coat_normal, Vec3f view,
                 bool entering)
      : MetalRoughBsdf(surface, albedo, Normals{normal, normal, coat_normal}, view, entering) {}

  /// Returns the light that the surface scatters from the unit direction `light` to the viewer, without Dirac lobes. `light`
  /// points away from the surface.
  BsdfValue evaluate(Vec3f light) const;

  /// Samples a direction by `lobe` and `u` in [0, 1). Returns nothing if no light arrives from the direction.
  std::optional<BsdfSample> sample(float lobe, Vec2f u) const;

  Vec3f diffuse_albedo() const { return below_coat_ * base_.diffuse_color * base_.diffuse_passes; }
  Vec3f evaluate_diffuse(Vec3f light) const;
  Vec3f normal() const { return basis_.z; }
  bool scatters_through() const { return glass_.share > 0.0f; }
  /// Returns whether a rough coat has a normal of its own. It may then receive light from behind normal().
  bool has_coat_apart() const;

 private:
  /// Probabilities with which sample() chooses a part. They add up to 1 or are all 0.
  struct Shares {
    float diffuse = 0.0f, gloss = 0.0f, glass = 0.0f, coat = 0.0f;
  };

  void set_coat(const MetalRoughSurface& s);
  void set_shares();

  Vec3f local_to_gloss(Vec3f world, Vec3f local) const { return glossy_apart_ ? gloss_basis_.to_local(world) : local; }
  void add_gloss(Vec3f light, BsdfValue& value) const;
  void add_glass(Vec3f light, BsdfValue& value) const;
  void add_coat(Vec3f light, BsdfValue& value) const;
  bool draw(float lobe, Vec2f u, BsdfSample& s) const;
  void weigh(BsdfSample& s) const;
  bool sample_glass(float decision, Vec2f u, BsdfSample& s) const;
  bool draw_coat(Vec2f u, BsdfSample& s) const;

  const GgxAlbedo& albedo_;
  Basis basis_, gloss_basis_, coat_basis_;
  bool glossy_apart_;
  MetalRoughBase base_;
  Vec3f coat_view_;
  float coat_alpha_;
  Glass glass_;
  float coat_ = 0.0f;
  float below_coat_ = 1.0f;
  Shares shares_;
};

}  // namespace lippmann
