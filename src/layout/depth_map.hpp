// Depth maps: grey of 8 or 16 bits, floats, the channel Z of an EXR file, or the depth image that a HEIC photo stores beside
// its colours.
//
// Integer samples are linear from 0 to 1, without the sRGB curve. Floats may have any unit; they are scaled so that the
// least becomes 0 and the greatest 1. Where there is no surface, renderers write NaN, infinity or values of 1e9 or more.
// Such values become 0 if they are negative, else 1.
#pragma once

#include <filesystem>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

struct DepthMapCoding {
  bool near_black = false;  ///< true: small values are near; false: large values are near
  /// True: values are linear in depth. False: they are linear in disparity.
  bool even_in_depth = false;
};

/// Returns the default coding of a file. Throws Error naming the file.
///   - The channel Z of an EXR file is linear in depth. If no value is negative, it is a distance from the camera; otherwise it
///     is a height above the display, as `render` writes it.
///   - The depth image of a HEIC photo states its own coding.
///   - All other files are linear in disparity, and white is near.
DepthMapCoding default_depth_coding(const std::filesystem::path& path);

/// Reads a map as grey for depth_of_grey() (layout/rgbd_side_file.hpp), with 1 channel, resized to `size` by enlarged_depth().
/// Throws Error naming the file if it has colours, is uniform or has another aspect ratio than `size`.
Image read_depth_map(const std::filesystem::path& path, Vec2i size, bool near_black);

/// Resizes a depth map in which large values are near. Interpolates between pixels of one surface. At edges, takes the nearer
/// surface, because edges of small maps are inexact and the colours of the foreground must not get the depth of the background.
/// Neighbours that differ by more than `edge` belong to two surfaces.
Image enlarged_depth(const Image& depth, Vec2i size, float edge);

}  // namespace lippmann
