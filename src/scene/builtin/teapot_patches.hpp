// The Utah teapot: Martin Newell's 32 bicubic patches of 1975, including the bottom.
#pragma once

#include <vector>

#include "scene/builtin/bezier_patch.hpp"

namespace lippmann::builtin {

/// Returns the patches in Newell's frame: z up, the spout along +x, standing on z = 0, with normals pointing outwards. Order:
/// rim (4), body (8), lid (8), bottom (4), handle (4), spout (4).
std::vector<BezierPatch> teapot_patches();

}  // namespace lippmann::builtin
