// Epipolar-plane images: one line of the display plane, seen by a row of eyes across the viewing zone.
//
// Based on: Bolles, Baker and Marimont, "Epipolar-plane image analysis: an approach to determining structure from motion", Int.
// J. Computer Vision 1, 1987. A scene point draws a straight line in the image. When the eye, at the viewing distance V, moves
// sideways by d V, the image of a point at depth z moves by -d z / (1 - z / V) on the display plane.
#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "lippmann/replay/taps.hpp"

namespace lippmann {

/// Returns the image of row `row` of the lens grid, counted from the top. Each column of the image shows one lens. Each row
/// shows what one eye sees. The view_counts(optics).x eyes are equally spaced, and the top row belongs to the leftmost eye.
/// Throws a usage Error naming `epi` if the display has no such row. The image is unfinished if `context` is cancelled.
Image epipolar_row(const RenderedPanel& rendered, int row, SampleFilter filter, const Context& context = {});

/// Returns the image of column `column` of the lens grid. Each row of the image shows one lens. Each column shows what one eye
/// sees, and the left column belongs to the lowest eye. Throws a usage Error naming `epi-column` if the display has no such
/// column or no vertical parallax.
Image epipolar_column(const RenderedPanel& rendered, int column, SampleFilter filter, const Context& context = {});

}  // namespace lippmann
