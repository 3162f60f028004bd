// Light behind surfaces that are not opaque, for the Whitted integrator.
#pragma once

#include "shading/surface.hpp"
#include "trace/ray_queue.hpp"

namespace lippmann {

/// Sets Branches::open: holes in alpha keep a ray open, transmission through glass closes it.
void keep_holes_open(const ShadedScene& scene, const SurfacePacket& surface, Branches& branches);

/// Multiplies the transmitted shares by the transmittance of thin walls along `rays`.
void tint_walls(const ShadedScene& scene, const SurfacePacket& surface, const RayPacket& rays, Branches& branches);

}  // namespace lippmann
