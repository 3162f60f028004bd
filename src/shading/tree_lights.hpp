// What lamps and triangles that shine are to a tree of lights.
#pragma once

#include "shading/light_tree.hpp"
#include "shading/materials.hpp"

namespace lippmann {

/// A lamp; without power where no tree serves it: it is at no place, or falls off by something else than the squared distance.
TreeLight tree_light(const WhittedLight& lamp);

/// A triangle with area. power: by area and radiance, in any unit that all triangles share.
TreeLight tree_light(Vec3f origin, Vec3f edge_b, Vec3f edge_c, float power);

}  // namespace lippmann
