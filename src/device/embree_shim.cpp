#include "device/embree_shim.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>

namespace lippmann {
namespace {

static_assert(RTC_MAX_INSTANCE_LEVEL_COUNT == 1, "one level of instances is all that scene_builder.cpp makes");

static_assert(kNoId == RTC_INVALID_GEOMETRY_ID);
static_assert(sizeof(RayPacket) == sizeof(RTCRay16) && alignof(RayPacket) == alignof(RTCRay16));
static_assert(offsetof(RayPacket, tnear) == offsetof(RTCRay16, tnear) &&
              offsetof(RayPacket, tfar) == offsetof(RTCRay16, tfar) && offsetof(RayPacket, flags) == offsetof(RTCRay16, flags));
static_assert(sizeof(HitPacket) >= sizeof(RTCHit16) && alignof(HitPacket) == alignof(RTCHit16));
static_assert(offsetof(HitPacket, primID) == offsetof(RTCHit16, primID) &&
              offsetof(HitPacket, instID) == offsetof(RTCHit16, instID));
static_assert(offsetof(RayHitPacket, hit) == offsetof(RTCRayHit16, hit));

template <class Wide, class Half>
void take_half(const Wide& wide, int half, Half& out) {
  constexpr std::size_t fields = sizeof(Half) / (8 * sizeof(float));
  static_assert(sizeof(Wide) >= fields * 16 * sizeof(float));
  const char* from = reinterpret_cast<const char*>(&wide) + half * 32;
  char* to = reinterpret_cast<char*>(&out);
  for (std::size_t f = 0; f < fields; ++f) std::memcpy(to + f * 32, from + f * 64, 32);
}

template <class Wide, class Half>
void put_half(const Half& in, int half, Wide& wide) {
  constexpr std::size_t fields = sizeof(Half) / (8 * sizeof(float));
  const char* from = reinterpret_cast<const char*>(&in);
  char* to = reinterpret_cast<char*>(&wide) + half * 32;
  for (std::size_t f = 0; f < fields; ++f) std::memcpy(to + f * 64, from + f * 32, 32);
}

RTCRay16* as_embree(RayPacket& packet) { return reinterpret_cast<RTCRay16*>(&packet); }
RTCRayHit16* as_embree(RayHitPacket& packet) { return reinterpret_cast<RTCRayHit16*>(&packet); }

#if RTC_VERSION_MAJOR >= 4
struct Query {
  RTCRayQueryContext context;
  RTCIntersectArguments arguments;
  explicit Query(Coherence coherence) {
    rtcInitRayQueryContext(&context);
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    arguments.flags = coherence == Coherence::kCoherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }
  auto* get() { return &arguments; }
};
#else
struct Query {
  RTCIntersectContext context;
  explicit Query(Coherence coherence) {
    rtcInitIntersectContext(&context);
    context.flags =
        coherence == Coherence::kCoherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
  auto* get() { return &context; }
};
#endif

}  // namespace

int native_packet_width(RTCDevice device) {
  if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return 16;
  if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)) return 8;
  return 4;
}

LIPPMANN_MULTIVERSION LaneMask sound_lanes(const RayPacket& rays, float reach, const LaneMask& active) {
  LaneMask sound;
  LIPPMANN_FOR_LANES(i) {
    const bool origin =
        (std::abs(rays.org_x[i]) <= reach) & (std::abs(rays.org_y[i]) <= reach) & (std::abs(rays.org_z[i]) <= reach);
    const bool direction =
        (std::abs(rays.dir_x[i]) <= reach) & (std::abs(rays.dir_y[i]) <= reach) & (std::abs(rays.dir_z[i]) <= reach);
    const bool range = (rays.tnear[i] >= 0.0f) & (rays.tnear[i] <= kInfinity) & (std::abs(rays.tfar[i]) <= kInfinity);
    sound.lane[i] = (origin & direction & range) ? active.lane[i] : 0;
  }
  return sound;
}

namespace {

/// `query` holds the arguments of the call (Embree 4) or its context (Embree 3).
template <class Query>
void intersect_packet(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, Query* query) {
  if (native_width != 8) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect16(active.lane, scene, as_embree(packet), query);
#else
    rtcIntersect16(active.lane, scene, query, as_embree(packet));
#endif
    return;
  }
  for (int half = 0; half < 2; ++half) {
    RTCRayHit8 rays;
    take_half(packet.ray, half, rays.ray);
    take_half(packet.hit, half, rays.hit);
    alignas(32) int valid[8];
    std::memcpy(valid, active.lane + 8 * half, sizeof(valid));
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect8(valid, scene, &rays, query);
#else
    rtcIntersect8(valid, scene, query, &rays);
#endif
    put_half(rays.ray, half, packet.ray);
    put_half(rays.hit, half, packet.hit);
  }
}

}  // namespace

void intersect(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, Coherence coherence) {
  Query query(coherence);
  intersect_packet(scene, native_width, active, packet, query.get());
}

void gather(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, SplatContext& context) {
#if RTC_VERSION_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  rtcInitRayQueryContext(&context.embree);
  arguments.context = &context.embree;
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  intersect_packet(scene, native_width, active, packet, &arguments);
#else
  rtcInitIntersectContext(&context.embree);
  context.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  intersect_packet(scene, native_width, active, packet, &context.embree);
#endif
}

void occluded(RTCScene scene, int native_width, const LaneMask& active, RayPacket& packet, ShadowContext& context) {
#if RTC_VERSION_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  rtcInitRayQueryContext(&context.embree);
  arguments.context = &context.embree;
  const auto query = &arguments;
#else
  rtcInitIntersectContext(&context.embree);  // not flagged as coherent, because rtcOccluded16 can then hang in Embree 3.13
  const auto query = &context.embree;
#endif
  if (native_width != 8) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded16(active.lane, scene, as_embree(packet), query);
#else
    rtcOccluded16(active.lane, scene, query, as_embree(packet));
#endif
    return;
  }
  for (int half = 0; half < 2; ++half) {
    RTCRay8 rays;
    take_half(packet, half, rays);
    alignas(32) int valid[8];
    std::memcpy(valid, active.lane + 8 * half, sizeof(valid));
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded8(valid, scene, &rays, query);
#else
    rtcOccluded8(valid, scene, query, &rays);
#endif
    put_half(rays, half, packet);
  }
}

}  // namespace lippmann
