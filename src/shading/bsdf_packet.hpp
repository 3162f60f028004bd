// The BSDFs at the hits of a packet. The most common surfaces are evaluated for all lanes at once: metallic roughness without
// coat or other layers, and purely diffuse surfaces. All other surfaces are evaluated lane by lane. The choice for a lane
// depends only on its own surface, so results do not depend on the other lanes.
#pragma once

#include <array>
#include <optional>

#include "shading/metal_rough_lanes.hpp"
#include "shading/shading_point.hpp"

namespace lippmann {

/// One sampled direction per lane. The members match those of BsdfSample.
struct BsdfSamples {
  BsdfSampleLanes lanes;
  LaneMask straight, is_vertex;

  std::optional<BsdfSample> get(int i) const {
    if (!(lanes.density[i] > 0.0f)) return std::nullopt;
    return BsdfSample{lanes.direction.get(i),         lanes.weight.get(i),   lanes.density[i],
                      lanes.transmitted.lane[i] != 0, straight.lane[i] != 0, is_vertex.lane[i] != 0};
  }
};

class BsdfPacket {
 public:
  void clear() {
    base_ = others_ = {};
    any_base_ = any_other_ = false;
    lanes_.clear();
  }
  /// Sets the surface that lane i has hit. Call set() for all lanes with a hit before any other function.
  void set(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface, int i);
  /// Computes the values that all evaluations share. Call prepare() once, after the last set().
  void prepare();

  // evaluate() and sample() fill the lanes of the mask, each of which must have a surface. Other lanes receive undefined
  // values. The random numbers lobe, u and v are in [0, 1).
  void evaluate(const LaneMask& lanes, const Lanes3& lights, BsdfValueLanes& values) const;
  void sample(const LaneMask& lanes, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSamples& samples) const;

  // These functions evaluate lane i only. They return what the functions of the same name in Bsdf return.
  Vec3f highlight(int i, Vec3f light) const { return base_.lane[i] ? Vec3f(0.0f) : bsdfs_[index(i)]->highlight(light); }
  Vec3f diffuse_albedo(int i) const { return base_.lane[i] ? lanes_.diffuse_albedo(i) : bsdfs_[index(i)]->diffuse_albedo(); }
  Vec3f evaluate_diffuse(int i, Vec3f light) const {
    return base_.lane[i] ? lanes_.evaluate_diffuse(i, *albedo_, light) : bsdfs_[index(i)]->evaluate_diffuse(light);
  }
  Vec3f lit_side(int i, Vec3f smooth) const {
    if (!base_.lane[i]) return bsdfs_[index(i)]->lit_side(smooth);
    return lanes_.scatters_through(i) ? Vec3f(0.0f) : lanes_.normal(i);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  LaneMask base_{}, others_{};  ///< base_: lanes whose surface is in lanes_; others_: lanes whose surface is in bsdfs_
  bool any_base_ = false, any_other_ = false;
  const GgxAlbedo* albedo_ = nullptr;
  MetalRoughLanes lanes_;
  std::array<std::optional<Bsdf>, kLanes> bsdfs_;
};

}  // namespace lippmann
