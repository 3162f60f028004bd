// The file poses_bounds.npy of LLFF data sets: 17 numbers per picture. The first 15 are a 3x5 matrix, row by row: the camera's
// axes down, right and backwards in the world, its position, and the height, width and focal length in pixels. The nearest and
// farthest depths follow.
//
// Mildenhall et al.: Local light field fusion, SIGGRAPH 2019.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "layout/posed_folder.hpp"

namespace lippmann {

/// Parses a file; picture paths are not set. Throws Error naming `where` and the row for invalid cameras.
std::vector<PosedPicture> parse_llff_poses(std::span<const std::byte> file, const std::string& where);

/// Encodes cameras. Throws Error naming `where` for non-square pixels and off-centre principal points, which the format cannot
/// express.
std::vector<std::byte> encode_llff_poses(const std::vector<PosedCamera>& cameras, Vec2d bounds_mm, const std::string& where);

}  // namespace lippmann
