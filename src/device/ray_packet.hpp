// A packet of sixteen rays and their hits, in Embree's memory layout.
#pragma once

#include "device/lanes.hpp"

namespace lippmann {

/// The caller sets origin, direction, tnear and tfar. make_ready() sets the other fields.
struct alignas(64) RayPacket {
  float org_x[kLanes], org_y[kLanes], org_z[kLanes], tnear[kLanes];
  float dir_x[kLanes], dir_y[kLanes], dir_z[kLanes], time[kLanes];
  float tfar[kLanes];
  unsigned mask[kLanes], id[kLanes], flags[kLanes];
};

LIPPMANN_INLINE void make_ready(RayPacket& rays) {
  LIPPMANN_FOR_LANES(i) {
    rays.time[i] = 0.0f;
    rays.mask[i] = ~0u;
    rays.id[i] = static_cast<unsigned>(i);
    rays.flags[i] = 0;
  }
}

/// The values of a lane are defined if its geomID is not kNoId.
struct alignas(64) HitPacket {
  /// Normal of the facet, any length; in mesh space if the mesh is an Embree instance, otherwise in world space.
  float Ng_x[kLanes], Ng_y[kLanes], Ng_z[kLanes];
  float u[kLanes], v[kLanes];  ///< barycentric weights of the triangle's second and third corner
  unsigned primID[kLanes], geomID[kLanes], instID[1][kLanes];
  unsigned reserved[kLanes];  ///< written by Embree if it supports instance arrays
};

struct alignas(64) RayHitPacket {
  RayPacket ray;
  HitPacket hit;
};

void clear_hits(RayHitPacket& packet);

inline constexpr unsigned kNoId = 0xffffffffu;
/// kPlaneId + p is the geometry id of the infinite plane p, and kLightId + l the geometry id of the visible light l.
inline constexpr unsigned kPlaneId = 0x80000000u;
inline constexpr unsigned kLightId = 0xC0000000u;

/// Bits of RayPacket::mask. A ray intersects only geometries whose mask shares a bit with the ray's mask. Rays that are neither
/// camera nor shadow rays have all bits set.
inline constexpr unsigned kCameraRay = 1, kShadowRay = 2;

enum class Coherence { kCoherent, kIncoherent };

}  // namespace lippmann
