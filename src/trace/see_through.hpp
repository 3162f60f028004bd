// What Whitted's rays find behind surfaces that are not opaque: how much of it is left, and how much of it nothing has shaped.
#pragma once

#include "shading/surface.hpp"
#include "trace/ray_queue.hpp"

namespace lippmann {

/// What alpha does not cover is as if nothing were there; what glass lets through has met the glass.
void keep_holes_open(const ShadedScene& scene, const SurfacePacket& surface, Branches& branches);

/// What thin walls take of the light behind them, which `rays` look at.
void tint_walls(const ShadedScene& scene, const SurfacePacket& surface, const RayPacket& rays, Branches& branches);

}  // namespace lippmann
