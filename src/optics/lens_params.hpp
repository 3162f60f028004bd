// Parameters that all lens arrays share.
//
// Lenses are 1 mm wide on the panel; all that matters is proportion: the panel is scaled to the fitted plane. For a lens cell
// c = pixels x pitch wide and a viewing zone of full angle a, the gap is g = c / (2 tan(a/2)). Cells that converge to a viewer
// at distance V belong to lenses of pitch p = c / (1 + g/V).
//
// width = lenses across x pixels below a lens. Where both and the size are given, they must agree to the pixel. The defaults
// are 64 lenses of 8 pixels.
#pragma once

#include "optics/optics_params.hpp"

namespace lippmann {

inline constexpr int kDefaultLenses = 64;

/// Returns the whole pixels that `lenses` cells of `pixels` cover: at least 1, clamped so that absurd sizes stay representable.
int covered_pixels(int lenses, float pixels);

/// Throws a usage Error unless `lenses` cells of `pixels` cover `size`, to the pixel. direction: "across" or "down".
void require_agreement(int size, int lenses, float pixels, const char* direction);

/// Returns the pixels below a lens, across: those of the parameters, or a lens's share of their size, or the default.
float lens_pixels_across(const OpticsParams& params);

/// Returns the centre of the cell nearest to the panel's middle, when a cell begins at the panel's edge, `extent` wide.
float cell_center_nearest_middle(float extent, float cell);

struct LensGeometry {
  float pitch_mm, gap_mm, pitch_per_cell;
};

LensGeometry lens_geometry(float cell_mm, const OpticsParams& params, float viewing_distance_mm);

}  // namespace lippmann
