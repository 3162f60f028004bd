// Computes height maps of the lenses of a lenticular sheet, for UV printers that print lenses onto an image.
//
// A lens is a cylindrical cap of pitch p, radius r and height s = r - sqrt(r^2 - p^2 / 4). The surface at distance x from the
// axis of the lens is sqrt(r^2 - x^2) - sqrt(r^2 - p^2 / 4) high. Lens axes are those of native_optics(), so that the heights
// fit the image that `convert` makes for the same display. Heights are sampled at pixel centres.
#pragma once

#include <optional>

#include "image/png.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Defines the shape of a lens. Exactly one of radius_mm, height_mm and thickness_mm must be given.
struct LensSpec {
  std::optional<double> radius_mm, height_mm;
  std::optional<double> thickness_mm;  ///< distance from the top of a lens to the print; the lens focuses on the print
  double refractive_index = 1.5;       ///< refractive index of the lens; about 1.5 for UV inks
};

struct LensShape {
  double pitch_mm = 0.0, radius_mm = 0.0, height_mm = 0.0;
  double thickness_mm = 0.0;    ///< distance from the top of a lens at which distant light focuses
  double view_angle_deg = 0.0;  ///< full angle over which a lens of thickness_mm shows its strip of the print
};

/// Returns the shape of the lenses. Throws a usage Error if the cap would exceed half a cylinder, or unless exactly one of the
/// three values is given.
LensShape lens_shape(double pitch_mm, const LensSpec& spec);

/// Returns the height map, with codes from 0 at the lens edges to 65535 at the tops. The result does not depend on the number
/// of threads.
HeightMap lens_heights(const Display& sheet, const LensShape& shape, const ThreadPool& pool);

}  // namespace lippmann
