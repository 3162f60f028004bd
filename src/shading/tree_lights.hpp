// Converts lamps and emissive triangles to the form of the light tree.
#pragma once

#include "shading/closed_mesh.hpp"
#include "shading/light_tree.hpp"
#include "shading/materials.hpp"
#include "shading/web_beams.hpp"

namespace lippmann {

/// Converts a lamp. The power is 0 if no tree supports it: a directional lamp, or one without inverse-square falloff. beam: of
/// its web, or null; it must outlive the building of the tree.
TreeLight tree_light(const WhittedLight& lamp, const WebBeam* beam = nullptr);

/// Converts a triangle with a positive area. power: by area and radiance, in any unit common to all triangles. closed: the
/// facing, if the triangle belongs to a closed mesh.
TreeLight tree_light(Vec3f origin, Vec3f edge_b, Vec3f edge_c, float power, BodyFacing closed = BodyFacing::kNone);

}  // namespace lippmann
