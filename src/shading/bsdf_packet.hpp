// How the surfaces of a packet scatter: glTF's commonest side by side, all others one by one. Which of both a lane is computed
// by depends on its own surface alone.
#pragma once

#include <array>
#include <optional>

#include "shading/metal_rough_lanes.hpp"
#include "shading/shading_point.hpp"

namespace lippmann {

/// A direction to follow from each of a packet's surfaces.
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
  /// No lane has any surface.
  void clear() {
    base_ = others_ = {};
    any_base_ = any_other_ = false;
    lanes_.clear();
  }
  /// The surface that lane i has hit. Those of a packet are all set before anything is asked.
  void set(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface, int i);
  /// Asked for once all are set.
  void prepare();

  // As those of Bsdf, for lanes of a mask that have a surface. Numbers in [0, 1).
  void evaluate(const LaneMask& lanes, const Lanes3& lights, BsdfValueLanes& values) const;
  void sample(const LaneMask& lanes, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSamples& samples) const;

  // And of one.
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

  LaneMask base_{}, others_{};  ///< lanes of lanes_, and of bsdfs_
  bool any_base_ = false, any_other_ = false;
  const GgxAlbedo* albedo_ = nullptr;
  MetalRoughLanes lanes_;
  std::array<std::optional<Bsdf>, kLanes> bsdfs_;
};

}  // namespace lippmann
