// The meaning of the grey half of an RGB-D picture, and its JSON side file <image>.json.
//
// Grey c from 0 to 1 (sample values without the sRGB curve) lies between the farthest and the nearest depth of a range, linear
// in z or in the disparity q(z) = z / (1 - z / D). Here D is the distance of the eye, and q is the shift of a point at z on the
// screen per unit slope of eye movement; it is finite at any distance. White is near unless `near_black`.
// moves by (D: the distance of the eye), or evenly in z. White is near unless `near_black`. q is finite however far a point is.
#pragma once

#include <filesystem>
#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/layout/depth_coding.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

struct RgbdSideFile {
  DepthCoding coding;
  double distance_mm = 300.0;   ///< from the eye to the screen
  Vec2d size_mm{100.0, 100.0};  ///< size of the screen filled by the picture
  Vec2d eye_mm{0.0};            ///< relative to the screen's axis, right and up

  bool operator==(const RgbdSideFile&) const = default;
};

double disparity_of_depth(double z_mm, double distance_mm);
double depth_of_disparity(double q_mm, double distance_mm);

/// Convert depth to grey, clamped to 0 ... 1 (-inf, no surface, is farthest), and grey to depth.
double grey_of_depth(const DepthCoding& coding, double distance_mm, double z_mm);
double depth_of_grey(const DepthCoding& coding, double distance_mm, double grey);

/// Returns a range that greys can represent: slightly extended if near and far are equal, and limited to depths in front of the
/// eye.
DepthRange range_before_eye(DepthRange range, double distance_mm);

std::filesystem::path rgbd_side_path(const std::filesystem::path& image);

/// Reads the side file; none if it does not exist or does not describe depth. Throws Error for impossible values.
std::optional<RgbdSideFile> read_rgbd_side_file(const std::filesystem::path& image);

void write_rgbd_side_file(const std::filesystem::path& image, const RgbdSideFile& side);

}  // namespace lippmann
