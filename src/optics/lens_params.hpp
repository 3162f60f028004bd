// Computes the geometry of lens arrays from the user's parameters.
//
// Lenses are 1 mm wide on the panel; only proportions matter, because the panel is scaled to the fitted plane. For a cell width
// c = pixels x pitch and a viewing zone of full angle a, the gap is g = c / (2 tan(a/2)). Cells that converge to a viewer at
// distance V have lenses of pitch p = c / (1 + g/V).
//
// The width is the number of lenses across times the number of pixels below a lens. If all three are given, they must agree to
// within one pixel. The default is 64 lenses of 8 pixels.
#pragma once

#include "optics/optics_params.hpp"

namespace lippmann {

inline constexpr int kDefaultLenses = 64;

/// Returns the number of whole pixels that `lenses` cells of `pixels` pixels cover: at least 1, clamped to the range of int.
int covered_pixels(int lenses, float pixels);

/// Throws a usage Error unless `lenses` x `pixels` differs from `size` by less than one pixel. `direction` ("across" or "down")
/// is for the message.
void require_agreement(int size, int lenses, float pixels, const char* direction);

/// Returns the number of pixels below a lens along a row: from the parameters, or the size divided by the number of lenses, or
/// the default.
float lens_pixels_across(const OpticsParams& params);

/// Returns the centre of the cell nearest to the panel's middle, relative to that middle, if a cell begins at the panel's edge
/// and the panel is `extent` wide.
float cell_center_nearest_middle(float extent, float cell);

struct LensGeometry {
  float pitch_mm, gap_mm, pitch_per_cell;
};

LensGeometry lens_geometry(float cell_mm, const OpticsParams& params, float viewing_distance_mm);

}  // namespace lippmann
