#pragma once

#include "shading/closed_mesh.hpp"
#include "shading/light_tree.hpp"
#include "shading/materials.hpp"
#include "shading/web_beams.hpp"

namespace lippmann {

/// Converts a lamp. The power is 0 for lamps that light trees do not support: directional lamps, and lamps without
/// inverse-square falloff. `beam` describes the lamp's photometric web and must exist until the tree is built; null: the lamp
/// has no web.
TreeLight tree_light(const WhittedLight& lamp, const WebBeam* beam = nullptr);

/// Converts a triangle with a positive area. `power` is proportional to area times radiance, in any unit that all triangles
/// share. `closed` is the facing of the triangle's mesh.
TreeLight tree_light(Vec3f origin, Vec3f edge_b, Vec3f edge_c, float power, BodyFacing closed = BodyFacing::kNone);

}  // namespace lippmann
