// What the grey half of an RGB-D picture means, and the JSON file beside it that says so, <image>.json.
//
// Grey c from 0 to 1 (codes as they are, without sRGB's curve) lies between the farthest and the nearest depth of a range,
// evenly in the disparity q(z) = z / (1 - z / D), by which a point at z moves on the screen per unit of the slope that the eye
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
  Vec2d size_mm{100.0, 100.0};  ///< how large the screen is that the picture fills
  Vec2d eye_mm{0.0};            ///< beside the screen's axis, right and up

  bool operator==(const RgbdSideFile&) const = default;
};

double disparity_of_depth(double z_mm, double distance_mm);
double depth_of_disparity(double q_mm, double distance_mm);

/// The grey of a depth, within 0 ... 1; what is beyond the range, or nothing at all (-inf), gets the nearest grey. And back.
double grey_of_depth(const DepthCoding& coding, double distance_mm, double z_mm);
double depth_of_grey(const DepthCoding& coding, double distance_mm, double grey);

/// The range as greys need it: a little of both around a plane, and nothing at the eye or behind it.
DepthRange range_before_eye(DepthRange range, double distance_mm);

std::filesystem::path rgbd_side_path(const std::filesystem::path& image);

/// Returns nothing if there is no such file or it does not describe depth. Throws Error where it says something impossible.
std::optional<RgbdSideFile> read_rgbd_side_file(const std::filesystem::path& image);

void write_rgbd_side_file(const std::filesystem::path& image, const RgbdSideFile& side);

}  // namespace lippmann
