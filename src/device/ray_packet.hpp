// A packet of sixteen rays and their hits.
//
// The memory layout is Embree's, so packets are passed on without conversion (embree_shim.cpp checks this), but no header
// depends on Embree.
#pragma once

#include "device/lanes.hpp"

namespace lippmann {

/// The caller sets origin, direction, tnear and tfar. make_ready() sets the other fields, which are internal to the device.
struct alignas(64) RayPacket {
  float org_x[kLanes], org_y[kLanes], org_z[kLanes], tnear[kLanes];
  float dir_x[kLanes], dir_y[kLanes], dir_z[kLanes], time[kLanes];
  float tfar[kLanes];
  unsigned mask[kLanes], id[kLanes], flags[kLanes];
};

/// Sets the fields that are internal to the device.
LIPPMANN_INLINE void make_ready(RayPacket& rays) {
  LIPPMANN_FOR_LANES(i) {
    rays.time[i] = 0.0f;
    rays.mask[i] = ~0u;
    rays.id[i] = static_cast<unsigned>(i);
    rays.flags[i] = 0;
  }
}

/// The hits of a packet. A lane's values are valid if its geomID is not kNoId.
struct alignas(64) HitPacket {
  float Ng_x[kLanes], Ng_y[kLanes], Ng_z[kLanes];  ///< normal of the facet, any length; in mesh space for placed meshes
  float u[kLanes], v[kLanes];                      ///< barycentric coordinates of a triangle's second and third corner
  unsigned primID[kLanes], geomID[kLanes], instID[1][kLanes];
  unsigned reserved[kLanes];  ///< written by versions of Embree that support instance arrays
};

struct alignas(64) RayHitPacket {
  RayPacket ray;
  HitPacket hit;
};

/// Prepares a packet for tracing and clears its hits.
void clear_hits(RayHitPacket& packet);

inline constexpr unsigned kNoId = 0xffffffffu;
/// Geometry ids from this value on are infinite planes.
inline constexpr unsigned kPlaneId = 0x80000000u;
/// Geometry ids from this value on are visible lights.
inline constexpr unsigned kLightId = 0xC0000000u;

/// Bits of RayPacket::mask. A ray intersects geometries whose mask shares a bit with its own mask. Rays of other kinds have all
/// bits set.
inline constexpr unsigned kCameraRay = 1, kShadowRay = 2;

/// States whether the rays of a packet have similar directions.
enum class Coherence { kCoherent, kIncoherent };

}  // namespace lippmann
