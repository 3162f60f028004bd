// The only header that includes Embree: device and scene ownership, 16-ray packets, and the few calls that differ between
// Embree 3.13 and 4.
//
// Packets are 16 rays wide everywhere. Where the machine is native at 8 (AVX2) a packet is traced as two halves, so that user
// geometry still sees whole native packets; elsewhere Embree splits it itself.
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

/// The packet width at which this device keeps packets whole: 16, 8 or 4.
int native_packet_width(RTCDevice device);

/// A context for occlusion queries that gather transmittance through see-through surfaces (geometry filters multiply it).
struct ShadowContext {
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext embree;
#else
  RTCIntersectContext embree;
#endif
  // `embree` comes first: Embree hands its address to filters, which take it for the whole. A ray's id is its lane.
  alignas(64) float transmittance[kLanes];
  Lanes3 tint;  ///< multiplies it where is_tinted
  bool is_tinted = false;
  const SceneGeometry* geometry = nullptr;  ///< what filters of meshes look hits up in
};

/// The active lanes whose rays are numbers, and whose coordinates lie within `reach`: less than kLargestReach where instances
/// magnify them. What is left out meets nothing. Scenes and optics are checked when they are loaded, but products of sound
/// numbers may still overflow on a ray's way.
LaneMask sound_lanes(const RayPacket& rays, float reach, const LaneMask& active);

/// Traces the active lanes, all of them sound; tfar and the hit of a lane change where something nearer than its tfar is met.
void intersect(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, Coherence coherence);

/// A context for queries that gather splats. `embree` comes first, as in ShadowContext; a ray's id is its lane.
struct SplatContext {
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext embree;
#else
  RTCIntersectContext embree;
#endif
  SplatHits* hits = nullptr;
};

/// Calls the geometries' intersect functions for what the active lanes, all of them sound, come near.
void gather(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, SplatContext& context);

/// Sets tfar of an active lane, all of them sound, to -inf where something lies between tnear and tfar.
/// `context.transmittance` must hold 1 for fresh lanes; it shrinks by each see-through surface passed.
void occluded(RTCScene scene, int native_width, const LaneMask& active, RayPacket& packet, ShadowContext& context);

}  // namespace lippmann
