// The meaning of the grey half of an RGB-D picture, and its JSON side file <image>.json. Grey from 0 to 1 lies between
// the farthest and the nearest depth of a range. It is linear in z or in the disparity q(z) = z / (1 - z / D), where
// D is the distance of the eye. A point at z moves on the screen by q(z) when the slope to the eye changes by 1.
// White is near unless `near_black`.
#pragma once

#include <filesystem>
#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/formats/depth_coding.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

struct RgbdSideFile {
  DepthCoding coding;
  double distance_mm = 300.0;   ///< from the eye to the screen
  Vec2d size_mm{100.0, 100.0};  ///< size of the screen, which the picture fills
  Vec2d eye_mm{0.0};            ///< relative to the screen's axis, right and up

  bool operator==(const RgbdSideFile&) const = default;
};

double disparity_of_depth(double z_mm, double distance_mm);
double depth_of_disparity(double q_mm, double distance_mm);

/// Grey is clamped to 0 ... 1; -inf (no surface) becomes the farthest grey.
double grey_of_depth(const DepthCoding& coding, double distance_mm, double z_mm);
double depth_of_grey(const DepthCoding& coding, double distance_mm, double grey);

/// Returns `range` limited to depths in front of the eye, and slightly extended if near and far are equal.
DepthRange range_before_eye(DepthRange range, double distance_mm);

std::filesystem::path rgbd_side_path(const std::filesystem::path& image);

/// Returns none if the side file does not exist or does not describe depth. Throws Error for impossible values.
std::optional<RgbdSideFile> read_rgbd_side_file(const std::filesystem::path& image);

void write_rgbd_side_file(const std::filesystem::path& image, const RgbdSideFile& side);

}  // namespace lippmann
