// Transmitted rays of the Whitted integrator, behind thin walls and behind surfaces that alpha makes transparent.
#pragma once

#include "shading/surface.hpp"
#include "trace/ray_queue.hpp"

namespace lippmann {

/// Sets branches.open, the factor on Bundle::open, to 1 - opacity for rays through surfaces that alpha makes transparent. The
/// factor stays 0 for rays through glass.
void keep_holes_open(const ShadedScene& scene, const SurfacePacket& surface, Branches& branches);

/// Multiplies the shares of transmitted rays by the transmittance of thin walls. `rays` are the rays that hit the walls.
void tint_walls(const ShadedScene& scene, const SurfacePacket& surface, const RayPacket& rays, Branches& branches);

}  // namespace lippmann
