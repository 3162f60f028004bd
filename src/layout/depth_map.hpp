// Depth maps: grey of 8 or 16 bits, floats, the channel Z of an EXR file, or the depth image that a HEIC photo stores beside
// its colours.
//
// Integer samples are linear from 0 to 1, without the sRGB curve. Floats may have any unit; they are scaled so that the least
// is 0 and the greatest 1. Renderers write values of 1e9 or more, infinity or NaN where there is no surface: negative ones
// become 0, others 1.
#pragma once

#include <filesystem>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

struct DepthMapCoding {
  bool near_black = false;     ///< small values are near
  bool even_in_depth = false;  ///< values are linear in depth instead of disparity
};

/// Returns the default coding of a file. The channel Z of an EXR file is linear in depth: a distance from the camera if no
/// value is negative, else a height above the display, as `render` writes it. The depth image of a HEIC photo states its
/// coding. All other files have white near and are linear in disparity. Throws Error naming the file.
DepthMapCoding default_depth_coding(const std::filesystem::path& path);

/// Reads a map as grey for depth_of_grey (layout/rgbd_side_file.hpp), with 1 channel, resampled to `size` by enlarged_depth().
/// Throws Error naming the file if it has colours, is uniform or has another aspect ratio than `size`.
Image read_depth_map(const std::filesystem::path& path, Vec2i size, bool near_black);

/// Resizes a depth map whose large values are near. Interpolates between pixels of one surface, and takes the nearer surface at
/// edges, because edges of small maps are inexact and foreground colours must not be assigned to the background. Neighbours
/// that differ by more than `edge` belong to two surfaces.
Image enlarged_depth(const Image& depth, Vec2i size, float edge);

}  // namespace lippmann
