// Transmitted rays of the Whitted integrator behind holes and thin walls.
#pragma once

#include "shading/surface.hpp"
#include "trace/ray_queue.hpp"

namespace lippmann {

/// Sets branches.open. Rays through holes by alpha stay open, while rays through glass do not.
void keep_holes_open(const ShadedScene& scene, const SurfacePacket& surface, Branches& branches);

/// Multiplies the shares of transmitted rays by the transmittance of thin walls. `rays` are the rays that hit the walls.
void tint_walls(const ShadedScene& scene, const SurfacePacket& surface, const RayPacket& rays, Branches& branches);

}  // namespace lippmann
