#include "shading/bsdf_packet.hpp"

namespace lippmann {
namespace {

/// Converts to the BSDF of lane i, so that emplace() constructs this large object in place.
struct BsdfOfLane {
  const ShadedScene& scene;
  const RayHitPacket& packet;
  const SurfacePacket& surface;
  int i;
  operator Bsdf() const { return bsdf_at(scene, packet, surface, i); }
};

}  // namespace

void BsdfPacket::set(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface, int i) {
  albedo_ = &scene.path->albedo;
  if (const std::optional<MetalRoughPoint> base = base_at(scene, packet, surface, i)) {
    lanes_.set(i, base->surface, base->normals, view_of(packet, i), surface.entering.lane[i] != 0);
    base_.lane[i] = -1, any_base_ = true;
  } else {
    bsdfs_[index(i)].emplace(BsdfOfLane{scene, packet, surface, i});
    others_.lane[i] = -1, any_other_ = true;
  }
}

void BsdfPacket::prepare() {
  if (any_base_) lanes_.prepare(*albedo_);
}

void BsdfPacket::evaluate(const LaneMask& lanes, const Lanes3& lights, BsdfValueLanes& values) const {
  if (any_base_) lanes_.evaluate(*albedo_, lights, values);
  if (!any_other_) return;
  for (int i = 0; i < kLanes; ++i) {
    if (!(lanes.lane[i] & others_.lane[i])) continue;
    values.set(i, bsdfs_[index(i)]->evaluate(lights.get(i)));
  }
}

void BsdfPacket::sample(const LaneMask& lanes, const Lanes& lobe, const Lanes& u, const Lanes& v, BsdfSamples& samples) const {
  if (any_base_) lanes_.sample(*albedo_, lobe, u, v, samples.lanes);
  LIPPMANN_FOR_LANES(i) {
    samples.straight.lane[i] = 0;
    samples.is_vertex.lane[i] = -1;
  }
  if (!any_other_) return;
  for (int i = 0; i < kLanes; ++i) {
    if (!(lanes.lane[i] & others_.lane[i])) continue;
    const std::optional<BsdfSample> sample = bsdfs_[index(i)]->sample(lobe[i], {u[i], v[i]});
    samples.lanes.set(i, sample ? *sample : BsdfSample{});
    if (!sample) continue;
    samples.straight.lane[i] = sample->straight ? -1 : 0;
    samples.is_vertex.lane[i] = sample->is_vertex ? -1 : 0;
  }
}

}  // namespace lippmann
