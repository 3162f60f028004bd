// Epipolar-plane images: one line of the display plane from eye after eye through the viewing zone.
//
// Bolles, Baker and Marimont, "Epipolar-plane image analysis: an approach to determining structure from motion", Int. J.
// Computer Vision 1, 1987. A point of the scene is a straight line in it: at depth z it crosses the display plane at a place
// that moves by -z / (1 - z / V) times what the eye's slope changes. Upright in the plane of the display, it leans one way
// behind and the other way before it.
#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "lippmann/replay/taps.hpp"

namespace lippmann {

/// The image of row `row` (of the lens grid, from the top): a column for each lens of it, a row for each eye, of
/// view_counts(optics).x equally far apart, the leftmost on top. With whole pixels below a lens these are the panel's own
/// pixels. Throws a usage Error naming `epi` for a row that the display does not have. Returns early, unfinished, when
/// `context` is cancelled.
Image epipolar_row(const RenderedPanel& rendered, int row, SampleFilter filter, const Context& context = {});

/// Likewise of a column: a row of the picture for each lens, a column for each eye, the lowest on the left.
/// Throws a usage Error naming `epi-column`, also where the display has no vertical parallax.
Image epipolar_column(const RenderedPanel& rendered, int column, SampleFilter filter, const Context& context = {});

}  // namespace lippmann
