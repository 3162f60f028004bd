// The depth of a picture, in a file of its own or in the photo itself: grey of 8 or 16 bits, floats, the channel Z of an EXR
// file, or the depth image that a HEIC photo stores beside its colours.
//
// Codes are plain numbers from 0 to 1, without sRGB's curve. Floats, of any unit, are scaled: the least is 0, the greatest 1.
// Renderers write numbers of 1e9 or more, infinite ones or NaN where there is no surface: below 0 they become 0, else 1.
#pragma once

#include <filesystem>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

struct DepthMapCoding {
  bool near_black = false;     ///< small numbers are near
  bool even_in_depth = false;  ///< numbers are linear in depth, not in disparity
};

/// The coding that a file has where nothing states it. The channel Z of an EXR file is linear in depth: a distance from the
/// camera if none of its numbers is below 0, else a height above the display, as `render` writes it. The depth image of a HEIC
/// photo states its coding. All other files are near where they are white, and linear in disparity. Throws Error naming the
/// file.
DepthMapCoding usual_depth_coding(const std::filesystem::path& path);

/// The greys as depth_of_grey (layout/rgbd_side_file.hpp) takes them, of 1 channel and that size: between pixels of one surface
/// in between, else those of the nearer surface. The edges of small maps are not exact, and colours of a near thing that were
/// taken for the wall behind it would be smeared over what comes into view. Throws Error naming the file if it has colours, the
/// same grey everywhere or another shape than `size`.
Image read_depth_map(const std::filesystem::path& path, Vec2i size, bool near_black);

/// A depth map, whose greatest numbers are near, in another size by the same rule. Neighbours that differ by more than `edge`
/// belong to two surfaces.
Image enlarged_depth(const Image& depth, Vec2i size, float edge);

}  // namespace lippmann
