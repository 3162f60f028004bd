// Depth maps: grey of 8 or 16 bits, floats, the channel Z of an EXR file, or the depth image of a HEIC photo. Integer
// samples are linear from 0 to 1. Floats of any unit are scaled to 0 ... 1. NaN, infinity and values of 1e9 or more
// mean no surface; they become 0 if they are negative, else 1.
#pragma once

#include <filesystem>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

struct DepthMapCoding {
  bool near_black = false;  ///< true: small values are near; false: large values are near
  /// true: values are linear in depth; false: values are linear in disparity
  bool even_in_depth = false;
};

/// Returns the default coding of a file. The channel Z of an EXR file is linear in depth: if any value is negative, the values
/// are heights above the display, otherwise distances from the camera. A HEIC photo states its own coding. All other files are
/// linear in disparity, with white near. Throws Error naming the file.
DepthMapCoding default_depth_coding(const std::filesystem::path& path);

/// Reads a map as grey for depth_of_grey() (formats/rgbd_side_file.hpp), with 1 channel, resized to `size` by
/// enlarged_depth(). Throws Error naming the file if it has colours, is uniform or has another aspect ratio than
/// `size`.
Image read_depth_map(const std::filesystem::path& path, Vec2i size, bool near_black);

/// Resizes a depth map in which large values are near. Interpolates within a surface, and takes the nearer surface at
/// edges, because the foreground's colours must not get the background's depth. Neighbours that differ by more than
/// `edge` belong to two surfaces.
Image enlarged_depth(const Image& depth, Vec2i size, float edge);

}  // namespace lippmann
