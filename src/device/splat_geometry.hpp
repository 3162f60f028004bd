// Splats as a geometry of Embree's.
#pragma once

#include "device/embree_scene.hpp"
#include "device/splat_hits.hpp"

namespace lippmann {

/// Fills the table of splats, and Embree's scene of them, for where `resolved` has their nodes.
void place_splats(const BuiltScene& built, const ResolvedScene& resolved);

/// Adds what the active lanes, all of them sound, meet from tnear to tfar.
void collect_splats(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, SplatHits& hits);

}  // namespace lippmann
