// Sixteen rays that are traced together, and what they have met.
//
// Words lie as Embree has them, so that packets are handed over as they are (embree_shim.cpp checks it), but no header names
// Embree.
#pragma once

#include "device/lanes.hpp"

namespace lippmann {

/// A ray has an origin, a direction, tnear and tfar; the other words are the device's.
struct alignas(64) RayPacket {
  float org_x[kLanes], org_y[kLanes], org_z[kLanes], tnear[kLanes];
  float dir_x[kLanes], dir_y[kLanes], dir_z[kLanes], time[kLanes];
  float tfar[kLanes];
  unsigned mask[kLanes], id[kLanes], flags[kLanes];
};

/// Sets the words that are the device's.
LIPPMANN_INLINE void make_ready(RayPacket& rays) {
  LIPPMANN_FOR_LANES(i) {
    rays.time[i] = 0.0f;
    rays.mask[i] = ~0u;
    rays.id[i] = static_cast<unsigned>(i);
    rays.flags[i] = 0;
  }
}

/// Valid where geomID is not kNoId.
struct alignas(64) HitPacket {
  float Ng_x[kLanes], Ng_y[kLanes], Ng_z[kLanes];  ///< normal of the facet, of any length; in mesh space where it is placed
  float u[kLanes], v[kLanes];                      ///< barycentric coordinates of a triangle's second and third corner
  unsigned primID[kLanes], geomID[kLanes], instID[1][kLanes];
  unsigned reserved[kLanes];  ///< written by devices that know arrays of instances
};

struct alignas(64) RayHitPacket {
  RayPacket ray;
  HitPacket hit;
};

/// Makes a packet ready whose rays have met nothing yet.
void clear_hits(RayHitPacket& packet);

inline constexpr unsigned kNoId = 0xffffffffu;
/// Geometry ids from here on name infinite planes.
inline constexpr unsigned kPlaneId = 0x80000000u;
/// Geometry ids from here on name visible lights.
inline constexpr unsigned kLightId = 0xC0000000u;

/// Bits of RayPacket::mask: a ray meets geometries whose mask has one of its bits. Other rays meet all.
inline constexpr unsigned kCameraRay = 1, kShadowRay = 2;

/// Whether the rays of a packet go about the same way.
enum class Coherence { kCoherent, kIncoherent };

}  // namespace lippmann
