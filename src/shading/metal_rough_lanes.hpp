// The BSDFs of sixteen points, one per lane, for Lambertian and metallic-roughness surfaces without coat or other layers. The
// results are bit-identical to MetalRoughBsdf.
#pragma once

#include <algorithm>

#include "device/lanes.hpp"
#include "transport/metal_rough_bsdf.hpp"

namespace lippmann {

struct BsdfValueLanes {
  Lanes3 cosine_f;
  Lanes density;
  LaneMask transmitted;

  LIPPMANN_INLINE void set(int i, const BsdfValue& value) {
    cosine_f.set(i, value.cosine_f);
    density[i] = value.density;
    transmitted.lane[i] = value.transmitted ? -1 : 0;
  }
  BsdfValue get(int i) const { return {cosine_f.get(i), density[i], transmitted.lane[i] != 0}; }
};

/// The BsdfSample of each lane. Density 0 marks lanes without a sample.
struct BsdfSampleLanes {
  Lanes3 direction, weight;
  Lanes density;
  LaneMask transmitted;

  LIPPMANN_INLINE void set(int i, const BsdfSample& sample) {
    direction.set(i, sample.direction);
    weight.set(i, sample.weight);
    density[i] = sample.density;
    transmitted.lane[i] = sample.transmitted ? -1 : 0;
  }
};

class MetalRoughLanes {
 public:
  void clear() { most_ = Kind::kLambert; }
  /// Sets lane i. Parameters of coat and other layers are ignored. `entering`: the viewer is outside the surface.
  void set(int i, const MetalRoughSurface& surface, const MetalRoughBsdf::Normals& normals, Vec3f view, bool entering);
  /// Call prepare() after all lanes are set. Lanes that are not set keep their old values.
  void prepare(const GgxAlbedo& albedo);

  // Same as MetalRoughBsdf::evaluate() and sample(), for all lanes.
  void evaluate(const GgxAlbedo& albedo, const Lanes3& lights, BsdfValueLanes& values) const;
  void sample(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSampleLanes& samples) const;

  // Same as the functions of MetalRoughBsdf, for lane i.
  Vec3f evaluate_diffuse(int i, const GgxAlbedo& albedo, Vec3f light) const;
  Vec3f diffuse_albedo(int i) const { return diffuse_color_.get(i) * diffuse_passes_.get(i); }
  Vec3f normal(int i) const { return normal_.get(i); }
  bool scatters_through(int i) const { return glass_[i] > 0.0f; }

 private:
  /// kGloss adds a glossy lobe to the diffuse lobe of kLambert, and kGlass adds glass. most_ is the largest Kind of all lanes
  /// and selects the kernels.
  enum class Kind { kLambert, kGloss, kGlass };

  struct GlassLanes {
    Lanes3 light;
    Lanes outward;
    LaneMask transmitted;
  };

  LIPPMANN_INLINE MetalRoughBase base(int i) const;
  LIPPMANN_INLINE Glass glass(int i) const;
  template <bool with_glass>
  LIPPMANN_INLINE BsdfValue evaluate(int i, const GgxAlbedo& albedo, Vec3f light) const;
  LIPPMANN_INLINE void draw_glass(int i, float lobe, Vec2f u, GlassLanes& drawn) const;
  /// Samples a direction. For Dirac lobes, density and weight are final. For other lobes, density and weight are set to 1 here
  /// and replaced by weigh().
  template <bool with_glass>
  LIPPMANN_INLINE BsdfSample draw(int i, float lobe, Vec2f u, const GlassLanes* by_glass) const;
  template <bool with_glass>
  LIPPMANN_INLINE void weigh(int i, const GgxAlbedo& albedo, BsdfSampleLanes& samples) const;
  void prepare_gloss(const GgxAlbedo& albedo);
  void prepare_lambert();
  void compensate_glass(const GgxAlbedo& albedo);
  void evaluate_lambert(const Lanes3& lights, BsdfValueLanes& values) const;
  void evaluate_gloss(const GgxAlbedo& albedo, const Lanes3& lights, BsdfValueLanes& values) const;
  void evaluate_glass(const GgxAlbedo& albedo, const Lanes3& lights, BsdfValueLanes& values) const;
  void sample_lambert(const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSampleLanes& samples) const;
  void sample_gloss(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSampleLanes& samples) const;
  void sample_glass(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSampleLanes& samples) const;

  Kind most_ = Kind::kLambert;
  Lanes3 base_color_{}, specular_color_{}, normal_{}, gloss_normal_{}, view_{};
  Lanes metallic_{}, roughness_{}, ior_{}, specular_{}, transmission_{};
  Lanes3 local_view_{}, diffuse_color_{}, diffuse_passes_{}, dielectric_f0_{}, gloss_f0_{}, gloss_compensation_{},
      gloss_albedo_{};
  Lanes alpha_{}, dielectric_f90_{}, gloss_f90_{};
  // The members of Glass, per lane. Its tint is base_color_.
  Lanes glass_{}, eta_{}, glass_compensation_{};
  /// Probabilities with which sample() chooses a lobe; they add up to 1 or are all 0
  Lanes diffuse_share_{}, gloss_share_{}, glass_share_{};
};

}  // namespace lippmann
