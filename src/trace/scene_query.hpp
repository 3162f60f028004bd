// One packet against everything that a ray can meet: planes, both Embree scenes, visible lights. Private to src/trace.
#pragma once

#include "trace/surface.hpp"

namespace lippmann {

LIPPMANN_INLINE LaneRay lane_ray(const RayPacket& ray, int i) {
  return {ray.org_x[i], ray.org_y[i], ray.org_z[i], ray.dir_x[i], ray.dir_y[i], ray.dir_z[i], ray.tnear[i], ray.tfar[i]};
}

/// Resets the hit part and the bookkeeping words of a packet whose origins, directions, tnear and tfar are set.
void clear_hits(RayHitPacket& packet);

/// The nearest hit of each active lane; origins, directions, tnear and tfar are set, and tfar becomes the hit's.
void find_nearest(const DeviceScene::Impl& scene, const LaneMask& active, RayHitPacket& packet, Coherence coherence);

}  // namespace lippmann
