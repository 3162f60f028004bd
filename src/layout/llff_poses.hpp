// poses_bounds.npy of LLFF's data sets: 17 numbers per picture. The first 15 are a 3x5 matrix, row by row: the camera's axes
// down, right and backwards in the world, its position, and the height, width and focal length in pixels. The nearest and
// farthest depth follow.
//
// Mildenhall et al.: Local light field fusion, SIGGRAPH 2019.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "layout/posed_folder.hpp"

namespace lippmann {

/// Throws Error naming `where` and the row for anything that makes no camera. Paths are unset.
std::vector<PosedPicture> parse_llff_poses(std::span<const std::byte> file, const std::string& where);

/// Throws Error naming `where` for pixels that are not square and axes that do not meet the middle of the picture, which the
/// format cannot state.
std::vector<std::byte> encode_llff_poses(const std::vector<PosedCamera>& cameras, Vec2d bounds_mm, const std::string& where);

}  // namespace lippmann
