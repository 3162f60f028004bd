// The BSDFs at the hits of a packet. Metallic roughness without further layers and purely diffuse surfaces are evaluated for
// all lanes at once, and all other surfaces lane by lane.
#pragma once

#include <array>
#include <optional>

#include "shading/metal_rough_lanes.hpp"
#include "shading/shading_point.hpp"

namespace lippmann {

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
  /// Call prepare() once, after the last set().
  void prepare();

  // evaluate() and sample() fill the lanes of the mask, each of which must have a surface. The random numbers lobe, u and v are
  // in [0, 1).
  void evaluate(const LaneMask& lanes, const Lanes3& lights, BsdfValueLanes& values) const;
  void sample(const LaneMask& lanes, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSamples& samples) const;

  // Same as the functions of the same name in Bsdf, for lane i.
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
