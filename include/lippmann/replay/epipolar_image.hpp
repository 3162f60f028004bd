// Epipolar-plane images: one line of the display plane, seen by a row of eyes across the viewing zone.
//
// Based on: Bolles, Baker and Marimont, "Epipolar-plane image analysis: an approach to determining structure from motion", Int.
// J. Computer Vision 1, 1987. A scene point draws a straight line in the image. When the slope of the eye changes by d, the
// image of a point at depth z moves by -d z / (1 - z / V) on the display plane, with V the viewing distance. Lines of points in
// the display plane are vertical. Points in front of the plane and points behind it lean to opposite sides.
#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "lippmann/replay/taps.hpp"

namespace lippmann {

/// Returns the epipolar-plane image of row `row` of the lens grid, counted from the top. Each column of the image shows one
/// lens of this row. Each row of the image shows what one eye sees. The view_counts(optics).x eyes are equally spaced, with the
/// leftmost on top. If every lens covers a whole number of pixels, the image consists of unchanged panel pixels. Throws a usage
/// Error naming `epi` if the display has no such row. Returns early, with an unfinished image, if `context` is cancelled.
Image epipolar_row(const RenderedPanel& rendered, int row, SampleFilter filter, const Context& context = {});

/// Returns the epipolar-plane image of column `column` of the lens grid. Each row of the image shows one lens of this column.
/// Each column of the image shows what one eye sees, with the lowest eye on the left. Throws a usage Error naming `epi-column`
/// if the display has no such column or no vertical parallax.
Image epipolar_column(const RenderedPanel& rendered, int column, SampleFilter filter, const Context& context = {});

}  // namespace lippmann
