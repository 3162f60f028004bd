// Computes height maps of the lenses of a lenticular sheet, for UV printers that print lenses onto an image.
//
// A lens is a cylindrical cap of pitch p and radius r. At distance x from its axis, the surface is sqrt(r^2 - x^2) - sqrt(r^2 -
// p^2 / 4) high. The lens axes match the image that `convert` makes for the same display. Heights are sampled at pixel centres.
#pragma once

#include <optional>

#include "image/png.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Shape of a lens. Exactly one of radius_mm, height_mm and thickness_mm must be given.
struct LensSpec {
  std::optional<double> radius_mm, height_mm;
  std::optional<double> thickness_mm;  ///< distance from the top of a lens to the print, where the lens focuses
  double refractive_index = 1.5;       ///< about 1.5 for UV inks
};

struct LensShape {
  double pitch_mm = 0.0, radius_mm = 0.0, height_mm = 0.0;
  double thickness_mm = 0.0;    ///< from the top of a lens to the focus of distant light
  double view_angle_deg = 0.0;  ///< full angle over which a lens of thickness_mm shows the strip of the print below it
};

/// Throws a usage Error if the cap would exceed half a cylinder, or unless `spec` has exactly one of radius, height and
/// thickness.
LensShape lens_shape(double pitch_mm, const LensSpec& spec);

/// Returns 16-bit heights: 0 at the lens edges, 65535 at the tops. The result does not depend on the number of threads.
HeightMap lens_heights(const Display& sheet, const LensShape& shape, const ThreadPool& pool);

}  // namespace lippmann
