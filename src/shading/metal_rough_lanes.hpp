// Sixteen points of the commonest surfaces side by side: the base of metallic roughness, without glass, coat or any layer, and
// Lambert's law, which is a base that has no gloss. What MetalRoughBsdf says of one, to the same bits.
#pragma once

#include "device/lanes.hpp"
#include "transport/metal_rough_bsdf.hpp"

namespace lippmann {

/// BsdfValue of sixteen points; none of these lies behind its surface.
struct BsdfValueLanes {
  Lanes3 cosine_f;
  Lanes density;
};

/// BsdfSample of sixteen points, all of them vertices and not behind the surface; density 0: none.
struct BsdfSampleLanes {
  Lanes3 direction, weight;
  Lanes density;
};

class MetalRoughLanes {
 public:
  /// Before the first lane is set.
  void clear() { any_gloss_ = false; }
  /// Only what the base is made of counts.
  void set(int i, const MetalRoughSurface& surface, const MetalRoughBsdf::Normals& normals, Vec3f view);
  /// After all lanes have been set; those that have not hold what they held before.
  void prepare(const GgxAlbedo& albedo);

  // As MetalRoughBsdf's, for all lanes.
  void evaluate(const GgxAlbedo& albedo, const Lanes3& lights, BsdfValueLanes& values) const;
  void sample(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSampleLanes& samples) const;
  void remove_diffuse();

  // And for one.
  BsdfValue evaluate_diffuse(int i, const GgxAlbedo& albedo, Vec3f light) const;
  Vec3f diffuse_albedo(int i) const { return diffuse_color_.get(i) * diffuse_passes_.get(i); }
  float diffuse_share(int i) const { return diffuse_share_[i]; }
  Vec3f normal(int i) const { return normal_.get(i); }
  bool is_sharp(int i) const { return alpha_[i] < kSmoothAlpha || gloss_share_[i] == 0.0f; }

 private:
  LIPPMANN_INLINE MetalRoughBase base(int i) const;
  LIPPMANN_INLINE void evaluate(int i, const GgxAlbedo& albedo, Vec3f light, Vec3f& cosine_f, float& density) const;
  void prepare_gloss(const GgxAlbedo& albedo);
  void prepare_lambert();
  void evaluate_gloss(const GgxAlbedo& albedo, const Lanes3& lights, BsdfValueLanes& values) const;
  void evaluate_lambert(const Lanes3& lights, BsdfValueLanes& values) const;
  void sample_gloss(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSampleLanes& samples) const;
  void sample_lambert(const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSampleLanes& samples) const;

  bool any_gloss_ = false;  ///< else the shorter kernels do
  // As they were set.
  Lanes3 base_color_{}, specular_color_{}, normal_{}, gloss_normal_{}, view_{};
  Lanes metallic_{}, roughness_{}, ior_{}, specular_{};
  // MetalRoughBase.
  Lanes3 local_view_{}, diffuse_color_{}, diffuse_passes_{}, dielectric_f0_{}, gloss_f0_{}, gloss_compensation_{},
      gloss_albedo_{};
  Lanes alpha_{}, dielectric_f90_{}, gloss_f90_{};
  Lanes diffuse_share_{}, gloss_share_{};  ///< probabilities of sample(); add up to 1 or are both 0
};

}  // namespace lippmann
