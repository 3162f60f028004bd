// Converts lamps and emissive triangles to the form of the light tree.
#pragma once

#include "shading/closed_mesh.hpp"
#include "shading/light_tree.hpp"
#include "shading/materials.hpp"
#include "shading/web_beams.hpp"

namespace lippmann {

/// Converts a lamp. The power is 0 if no tree supports it: a directional lamp, or one without inverse-square falloff. beam: the
/// beam of the lamp's web, or null; it must exist until the tree is built.
TreeLight tree_light(const WhittedLight& lamp, const WebBeam* beam = nullptr);

/// Converts a triangle with a positive area. power: in proportion to area and radiance, in any unit that all triangles share.
/// closed: the facing, if the triangle belongs to a closed mesh.
TreeLight tree_light(Vec3f origin, Vec3f edge_b, Vec3f edge_c, float power, BodyFacing closed = BodyFacing::kNone);

}  // namespace lippmann
