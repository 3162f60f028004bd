#pragma once

#include "shading/surface.hpp"
#include "trace/ray_queue.hpp"

namespace lippmann {

/// Sets branches.open to 1 - opacity behind surfaces that alpha makes transparent.
void keep_holes_open(const ShadedScene& scene, const SurfacePacket& surface, Branches& branches);

void tint_walls(const ShadedScene& scene, const SurfacePacket& surface, const RayPacket& rays, Branches& branches);

}  // namespace lippmann
