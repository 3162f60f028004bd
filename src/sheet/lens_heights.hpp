// The lenses of a lenticular sheet as heights, for UV printers that print the lens onto the picture.
//
// Each lens is a cylindrical cap of the pitch p, the radius r and the height s = r - sqrt(r^2 - p^2 / 4); at the distance x
// from its axis it is sqrt(r^2 - x^2) - sqrt(r^2 - p^2 / 4) high. Lens axes lie where native_optics() has them, so that the
// heights belong to the print that `convert` makes for the same display. A height is that at a pixel's centre.
#pragma once

#include <optional>

#include "image/png.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// One of three values gives the shape.
struct LensSpec {
  std::optional<double> radius_mm, height_mm;
  std::optional<double> thickness_mm;  ///< from the top of a lens to the print, on which it is to focus
  double refractive_index = 1.5;       ///< of the lens; UV inks: about 1.5
};

struct LensShape {
  double pitch_mm = 0.0, radius_mm = 0.0, height_mm = 0.0;
  double thickness_mm = 0.0;    ///< at which distant light focuses on the print
  double view_angle_deg = 0.0;  ///< full angle over which a lens shows its strip, if it is that thick
};

/// Throws a usage Error naming `radius-mm`, `height-mm` or `thickness-mm` for caps that would be more than half a cylinder, and
/// `thickness-mm` unless exactly one value is given.
LensShape lens_shape(double pitch_mm, const LensSpec& spec);

/// 0 is the height of the lens edges, 65535 that of the tops. The same for any number of threads.
HeightMap lens_heights(const Display& sheet, const LensShape& shape, const ThreadPool& pool);

}  // namespace lippmann
