// One packet against everything that a ray can meet: planes, both Embree scenes, visible lights. Private to src/trace.
#pragma once

#include "trace/surface.hpp"

namespace lippmann {

/// Resets the hit part and the bookkeeping words of a packet whose origins, directions, tnear and tfar are set.
void clear_hits(RayHitPacket& packet);

/// The nearest hit of each active lane.
void intersect_scene(const DeviceScene::Impl& scene, const LaneMask& active, RayHitPacket& packet, Coherence coherence);

}  // namespace lippmann
