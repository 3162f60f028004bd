// Wraps Embree 3.13 and 4, so that no other header includes Embree's headers.
//
// All packets have 16 rays. On machines with 8 native lanes (AVX2), a packet is traced as two halves, so that callbacks of user
// geometries still get full native packets.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstdint>
#include <utility>

#include "device/ray_packet.hpp"
#include "device/scene_geometry.hpp"
#include "device/splat_hits.hpp"

namespace lippmann {

template <class Handle, void (*release)(Handle)>
class EmbreeHandle {
 public:
  EmbreeHandle() = default;
  explicit EmbreeHandle(Handle handle) : handle_(handle) {}
  EmbreeHandle(EmbreeHandle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  EmbreeHandle& operator=(EmbreeHandle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~EmbreeHandle() {
    if (handle_) release(handle_);
  }
  Handle get() const { return handle_; }
  explicit operator bool() const { return handle_ != nullptr; }

 private:
  Handle handle_ = nullptr;
};

using EmbreeDevice = EmbreeHandle<RTCDevice, rtcReleaseDevice>;
using EmbreeScene = EmbreeHandle<RTCScene, rtcReleaseScene>;
using EmbreeGeometry = EmbreeHandle<RTCGeometry, rtcReleaseGeometry>;

int native_packet_width(RTCDevice device);

/// The context of an occlusion query. At transparent surfaces, geometry filters reduce the transmittance.
struct ShadowContext {
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext embree;
#else
  RTCIntersectContext embree;
#endif
  // `embree` must be the first member, because Embree passes its address to filters, which cast it to ShadowContext. The id of
  // a ray is its lane.
  alignas(64) float transmittance[kLanes];
  Lanes3 tint;
  bool is_tinted = false;
  const SceneGeometry* geometry = nullptr;  ///< lets filters of meshes look up hits
};

/// Returns the active lanes whose rays have coordinates from -reach to reach. All other rays, such as those with NaN or
/// infinite coordinates after an overflow, hit nothing.
LaneMask sound_lanes(const RayPacket& rays, float reach, const LaneMask& active);

/// Traces the active lanes, which must come from sound_lanes(). Sets tfar and the hit of each lane that hits something nearer
/// than its tfar.
void intersect(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, Coherence coherence);

/// The context of a query that collects splats. `embree` must be the first member, as in ShadowContext. The id of a ray is its
/// lane.
struct SplatContext {
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext embree;
#else
  RTCIntersectContext embree;
#endif
  SplatHits* hits = nullptr;
};

/// Calls the intersect functions of user geometries for all primitives that the active lanes may hit. The lanes must come from
/// sound_lanes().
void gather(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, SplatContext& context);

/// Sets tfar to -inf for active lanes that are occluded between tnear and tfar. The lanes must come from sound_lanes(). The
/// caller sets context.transmittance to 1, and each transparent surface on the way multiplies it by its own transmittance.
void occluded(RTCScene scene, int native_width, const LaneMask& active, RayPacket& packet, ShadowContext& context);

}  // namespace lippmann
