// Computes the geometry of lens arrays from the user's parameters.
//
// Cells are 1 mm wide, because the panel is later scaled to fit the scene. For a cell width c and a viewing zone of full angle
// a, the gap is g = c / (2 tan(a/2)). If cells converge to a viewer at distance V, the lens pitch is p = c / (1 + g/V).
//
// The width of the panel in pixels is the number of lenses across times the number of pixels below a lens. If all three are
// given, they must agree to within one pixel. The default is 64 lenses of 8 pixels.
#pragma once

#include "optics/optics_params.hpp"

namespace lippmann {

inline constexpr int kDefaultLenses = 64;

/// Returns lenses * pixels as a whole number, at least 1 and clamped to the range of int.
int covered_pixels(int lenses, float pixels);

/// Throws a usage Error unless `lenses` x `pixels` differs from `size` by less than one pixel. The message contains `direction`
/// ("across" or "down").
void require_agreement(int size, int lenses, float pixels, const char* direction);

/// Returns the number of pixels below a lens along a row: the given number, or the panel's width divided by the number of
/// lenses, or the default.
float lens_pixels_across(const OpticsParams& params);

/// Returns the centre of the cell that contains the middle of the panel, relative to the middle. The panel is `extent` wide.
/// Cells are `cell` wide, and the first cell begins at the edge of the panel.
float cell_center_nearest_middle(float extent, float cell);

struct LensGeometry {
  float pitch_mm, gap_mm, pitch_per_cell;
};

LensGeometry lens_geometry(float cell_mm, const OpticsParams& params, float viewing_distance_mm);

}  // namespace lippmann
