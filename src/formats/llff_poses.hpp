// The file poses_bounds.npy of LLFF data sets has 17 numbers per picture:
//   - a 3x5 matrix, row by row, with the columns down, right and backwards (the camera's axes in the world), the position, and
//     (height, width, focal length) in pixels;
//   - the nearest and the farthest depth.
//
// Mildenhall et al.: Local light field fusion, SIGGRAPH 2019.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "formats/posed_folder.hpp"

namespace lippmann {

/// Parses a file. Sets the depth bounds of the pictures, but not their paths. Throws Error naming `where` and the picture's row
/// in the file for invalid cameras.
std::vector<PosedPicture> parse_llff_poses(std::span<const std::byte> file, const std::string& where);

/// Encodes cameras, with the nearest and the farthest depth for each camera. Throws Error naming `where` if pixels are not
/// square or a principal point is not in the middle, which the format cannot express.
std::vector<std::byte> encode_llff_poses(const std::vector<PosedCamera>& cameras, const std::vector<Vec2d>& bounds_mm,
                                         const std::string& where);

}  // namespace lippmann
