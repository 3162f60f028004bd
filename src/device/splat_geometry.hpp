#pragma once

#include "device/embree_scene.hpp"
#include "device/splat_hits.hpp"

namespace lippmann {

void place_splats(const BuiltScene& built, const ResolvedScene& resolved);

/// Adds to `hits` the splats that the active lanes hit between tnear and tfar. The lanes must come from sound_lanes().
void collect_splats(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, SplatHits& hits);

}  // namespace lippmann
