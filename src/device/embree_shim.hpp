// Wraps Embree; no other header includes it. Provides ownership of devices and scenes, 16-ray packets, and the calls that
// differ between Embree 3.13 and 4.
//
// Packets are 16 rays wide everywhere. On machines with 8 native lanes (AVX2), a packet is traced as two halves, so user
// geometry callbacks still get whole native packets. On other machines, Embree splits packets itself.
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

/// Owns a reference-counted Embree handle.
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

/// Returns the packet width that the device supports natively: 16, 8 or 4.
int native_packet_width(RTCDevice device);

/// A context for occlusion queries. Geometry filters multiply its transmittance at see-through surfaces.
struct ShadowContext {
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext embree;
#else
  RTCIntersectContext embree;
#endif
  // `embree` must come first: Embree passes its address to filters, which cast it to this type. The id of a ray is its lane.
  alignas(64) float transmittance[kLanes];
  Lanes3 tint;  ///< multiplies the transmittance if is_tinted is set
  bool is_tinted = false;
  const SceneGeometry* geometry = nullptr;  ///< used by filters of meshes to look up hits
};

/// Returns the active lanes whose rays have finite coordinates within `reach`, which is less than kLargestReach if instances
/// magnify coordinates. Other lanes hit nothing. Scenes and optics are checked at load time, but products of valid numbers may
/// still overflow.
LaneMask sound_lanes(const RayPacket& rays, float reach, const LaneMask& active);

/// Traces the active lanes, which must be sound. Changes tfar and the hit of a lane if there is a hit nearer than its tfar.
void intersect(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, Coherence coherence);

/// A context for queries that collect splats. `embree` must come first, as in ShadowContext; a ray's id is its lane.
struct SplatContext {
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext embree;
#else
  RTCIntersectContext embree;
#endif
  SplatHits* hits = nullptr;
};

/// Calls the geometries' intersect functions for all candidates of the active lanes, which must be sound.
void gather(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, SplatContext& context);

/// Sets tfar to -inf for active lanes that are occluded between tnear and tfar. The lanes must be sound. Initialize
/// `context.transmittance` to 1; each see-through surface multiplies it.
void occluded(RTCScene scene, int native_width, const LaneMask& active, RayPacket& packet, ShadowContext& context);

}  // namespace lippmann
