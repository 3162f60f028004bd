// The interface for tracing rays. The rest of this folder is the implementation.
#pragma once

#include <memory>
#include <vector>

#include "device/ray_packet.hpp"
#include "device/scene_geometry.hpp"
#include "device/shadow_materials.hpp"
#include "device/splat_hits.hpp"
#include "device/transmittance.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// Build a RayScene once per scene, and update it once per frame. Any number of threads may trace at once, but not during
/// update().
class RayScene : public SceneGeometry {
 public:
  /// Builds the scene in the state `resolved`, which must be the first frame of the timeline. `scene`, and the data that the
  /// casters of `materials` refer to, must outlive this object.
  RayScene(const Scene& scene, const ResolvedScene& resolved, const ShadowMaterials& materials, const ThreadPool& pool);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  void update(const ResolvedScene& resolved, const ThreadPool& pool);

  /// Finds the nearest hit of each active lane, and sets tfar to its distance. Without a hit, tfar is unchanged. `of_cameras`
  /// marks camera rays that have not been scattered; they may have passed surfaces made transparent by alpha. Marked rays
  /// ignore objects that are hidden from cameras.
  void trace(const LaneMask& active, RayHitPacket& packet, Coherence coherence, const LaneMask* of_cameras = nullptr) const;

  /// Sets tfar to -inf for active lanes that an opaque surface occludes between tnear and tfar. In the other active lanes,
  /// multiplies transmittance.white by the transmittance of the surfaces. Earlier values of transmittance.tint are discarded.
  /// Removes lanes with invalid rays from `active`, so that they receive no light.
  void trace_shadows(LaneMask& active, RayPacket& rays, Transmittance& transmittance) const;

  bool has_splats() const { return !splats.splats.empty(); }
  /// Collects the splats along the active rays, up to the point where the transmittance falls below kDark.
  void meet_splats(const LaneMask& active, const RayPacket& rays, SplatHits& hits) const;

  struct Embree;
  const Embree& embree() const { return *embree_; }  ///< only for src/device and its benchmarks

 private:
  std::unique_ptr<Embree> embree_;
};

}  // namespace lippmann
