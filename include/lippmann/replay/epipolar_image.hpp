// Epipolar-plane images: one line of the display plane, seen by a row of eyes across the viewing zone.
//
// Based on: Bolles, Baker and Marimont, "Epipolar-plane image analysis: an approach to determining structure from motion", Int.
// J. Computer Vision 1, 1987. A scene point draws a straight line in the image. When the slope of the eye changes by d, the
// image of a point at depth z moves by -d z / (1 - z / V) on the display plane, with V the viewing distance. Lines of points in
// the display plane are vertical.
#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "lippmann/replay/taps.hpp"

namespace lippmann {

/// Returns the image of row `row` of the lens grid, counted from the top. Each column of the image shows one lens, and each row
/// what one of view_counts(optics).x equally spaced eyes sees, the leftmost on top. Throws a usage Error naming `epi` if the
/// display has no such row. The image is unfinished if `context` is cancelled.
Image epipolar_row(const RenderedPanel& rendered, int row, SampleFilter filter, const Context& context = {});

/// Returns the image of column `column` of the lens grid. Each row of the image shows one lens, and each column what one eye
/// sees, the lowest at the left. Throws a usage Error naming `epi-column` if the display has no such column or no vertical
/// parallax.
Image epipolar_column(const RenderedPanel& rendered, int column, SampleFilter filter, const Context& context = {});

}  // namespace lippmann
