// What lamps and triangles that shine are to a tree of lights.
#pragma once

#include "shading/closed_mesh.hpp"
#include "shading/light_tree.hpp"
#include "shading/materials.hpp"
#include "shading/web_beams.hpp"

namespace lippmann {

/// A lamp; without power where no tree serves it: it is at no place, or falls off by something else than the squared distance.
/// beam: of its web, which outlives the building of the tree; null where it has none.
TreeLight tree_light(const WhittedLight& lamp, const WebBeam* beam = nullptr);

/// A triangle with area. power: by area and radiance, in any unit that all triangles share. closed: which way it faces, as one
/// of a closed mesh.
TreeLight tree_light(Vec3f origin, Vec3f edge_b, Vec3f edge_c, float power, BodyFacing closed = BodyFacing::kNone);

}  // namespace lippmann
