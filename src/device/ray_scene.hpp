// The interface of the ray tracing device, whose implementation is the rest of this folder. update() moves the scene; trace()
// and trace_shadows() trace rays.
//
// The data that hits refer to (records, planes) is public, because shading reads it. The device's own structures are private.
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

/// Build once per scene and update once per frame. Static objects are built once; rigidly moving objects are transformed, not
/// rebuilt. Any number of threads may trace concurrently; update() must not overlap with tracing.
class RayScene : public SceneGeometry {
 public:
  /// Builds the scene as `resolved`, the first moment of the timeline, has it. `scene` and the data used by the casters of
  /// `materials` must outlive this object.
  RayScene(const Scene& scene, const ResolvedScene& resolved, const ShadowMaterials& materials, const ThreadPool& pool);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Moves all objects to their places in `resolved`.
  void update(const ResolvedScene& resolved, const ThreadPool& pool);

  /// Finds the nearest hit of each active lane and sets tfar to its distance; tfar stays unchanged without a hit. `of_cameras`
  /// marks lanes whose camera rays have passed only holes; these ignore objects hidden from cameras. Null marks no lanes.
  void trace(const LaneMask& active, RayHitPacket& packet, Coherence coherence, const LaneMask* of_cameras = nullptr) const;

  /// Sets tfar to -inf for active lanes that are occluded by an opaque surface between tnear and tfar, and multiplies the
  /// transmittance of the others by that of see-through surfaces. Multiplies transmittance.white in place and resets the tint
  /// before tracing. Removes lanes with invalid rays from `active`, so they receive no light.
  void trace_shadows(LaneMask& active, RayPacket& rays, Transmittance& transmittance) const;

  bool has_splats() const { return !splats.splats.empty(); }
  /// Collects the splats along the active rays from tnear to tfar, until the transmittance falls below kDark.
  void meet_splats(const LaneMask& active, const RayPacket& rays, SplatHits& hits) const;

  struct Embree;
  const Embree& embree() const { return *embree_; }  ///< for this part and its benchmarks

 private:
  std::unique_ptr<Embree> embree_;
};

}  // namespace lippmann
