// Sixteen points of the commonest surfaces side by side: the base of metallic roughness with its glass, without coat or any
// layer, and Lambert's law, which is a base that has no gloss. What MetalRoughBsdf says of one, to the same bits.
#pragma once

#include <algorithm>

#include "device/lanes.hpp"
#include "transport/metal_rough_bsdf.hpp"

namespace lippmann {

/// BsdfValue of sixteen points.
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

/// BsdfSample of sixteen points, all of them vertices; density 0: none.
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
  /// Before the first lane is set.
  void clear() { most_ = Kind::kLambert; }
  /// Only what the base and its glass are made of counts. entering: the viewer is outside.
  void set(int i, const MetalRoughSurface& surface, const MetalRoughBsdf::Normals& normals, Vec3f view, bool entering);
  /// After all lanes have been set; those that have not hold what they held before.
  void prepare(const GgxAlbedo& albedo);

  // As MetalRoughBsdf's, for all lanes.
  void evaluate(const GgxAlbedo& albedo, const Lanes3& lights, BsdfValueLanes& values) const;
  void sample(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSampleLanes& samples) const;

  // And for one.
  Vec3f evaluate_diffuse(int i, const GgxAlbedo& albedo, Vec3f light) const;
  Vec3f diffuse_albedo(int i) const { return diffuse_color_.get(i) * diffuse_passes_.get(i); }
  Vec3f normal(int i) const { return normal_.get(i); }
  bool scatters_through(int i) const { return glass_[i] > 0.0f; }

 private:
  /// What a lane has; the shortest kernels that know all lanes do.
  enum class Kind { kLambert, kGloss, kGlass };

  /// lippmann::draw_glass() of all lanes.
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
  /// Density and weight of Dirac's lobes alone; of others 1, for weigh().
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
  // As they were set.
  Lanes3 base_color_{}, specular_color_{}, normal_{}, gloss_normal_{}, view_{};
  Lanes metallic_{}, roughness_{}, ior_{}, specular_{}, transmission_{};
  // MetalRoughBase.
  Lanes3 local_view_{}, diffuse_color_{}, diffuse_passes_{}, dielectric_f0_{}, gloss_f0_{}, gloss_compensation_{},
      gloss_albedo_{};
  Lanes alpha_{}, dielectric_f90_{}, gloss_f90_{};
  // Glass, whose tint is base_color_.
  Lanes glass_{}, eta_{}, glass_compensation_{};
  Lanes diffuse_share_{}, gloss_share_{}, glass_share_{};  ///< probabilities of sample(); add up to 1 or are all 0
};

}  // namespace lippmann
