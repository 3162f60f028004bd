#pragma once

#include <vector>

#include "scene/builtin/bezier_patch.hpp"

namespace lippmann::builtin {

/// Returns the patches in Newell's coordinates: z points up, the spout points along +x, and the pot stands on z = 0. Normals
/// point outwards. Order: rim (4 patches), body (8), lid (8), bottom (4), handle (4), spout (4).
std::vector<BezierPatch> teapot_patches();

}  // namespace lippmann::builtin
