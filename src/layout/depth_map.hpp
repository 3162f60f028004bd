// Depth in a file of its own, beside a picture: grey of 8 or 16 bits, floats, or the channel Z of an EXR file.
//
// Codes are plain numbers from 0 to 1, without sRGB's curve. Floats, of any unit, are scaled: the least is 0, the greatest 1.
// Numbers that are not finite, and those of 1e9 or more, by which renderers mean nothing at all, become the greatest of the
// others.
#pragma once

#include <filesystem>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// The greys as depth_of_grey (layout/rgbd_side_file.hpp) takes them, of 1 channel and that size: between pixels of one surface
/// in between, else those of the nearer surface. The edges of small maps are not exact, and colours of a near thing that were
/// taken for the wall behind it would be smeared over what comes into view. Throws Error naming the file if it has colours, the
/// same grey everywhere or another shape than `size`.
Image read_depth_map(const std::filesystem::path& path, Vec2i size, bool near_black);

/// A depth map, whose greatest numbers are near, in another size by the same rule. Neighbours that differ by more than `edge`
/// belong to two surfaces.
Image enlarged_depth(const Image& depth, Vec2i size, float edge);

}  // namespace lippmann
