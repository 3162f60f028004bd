// What rays meet: the only entrance to the device that traces them. A device is this class and the files of this part: update()
// moves a scene, trace() and trace_shadows() follow rays through it.
//
// What hits refer to (records, planes) is public: shading reads it. The device's own structures are not.
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

/// Built once per scene, updated once per frame. What never moves is built once; what moves rigidly is moved, not rebuilt.
/// Tracing reads it from any number of threads; update() must not overlap with it.
class RayScene : public SceneGeometry {
 public:
  /// Stands at the timeline's first moment. `scene` outlives it, as do the casters that `materials` gives.
  RayScene(const Scene& scene, const ResolvedScene& resolved, const ShadowMaterials& materials, const ThreadPool& pool);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Moves everything to where `resolved` has it.
  void update(const ResolvedScene& resolved, const ThreadPool& pool);

  /// The nearest hit of each active lane: tfar becomes its distance, and stays where there is none. of_cameras: the lanes whose
  /// rays come from cameras, with nothing but holes on their way, and do not meet what is hidden from these; null: none.
  void trace(const LaneMask& active, RayHitPacket& packet, Coherence coherence, const LaneMask* of_cameras = nullptr) const;

  /// Sets tfar of active lanes to -inf where something opaque lies between tnear and tfar, and multiplies their transmittance
  /// by what see-through surfaces let pass: `white` is read and written, the tint begins anew. Takes lanes whose rays are no
  /// numbers out of `active`: they get no light.
  void trace_shadows(LaneMask& active, RayPacket& rays, Transmittance& transmittance) const;

  bool has_splats() const { return !splats.splats.empty(); }
  /// The splats on the active rays' way from tnear to tfar, as far as something shines through those before them.
  void meet_splats(const LaneMask& active, const RayPacket& rays, SplatHits& hits) const;

  struct Embree;
  const Embree& embree() const { return *embree_; }  ///< for this part and benchmarks of it

 private:
  std::unique_ptr<Embree> embree_;
};

}  // namespace lippmann
