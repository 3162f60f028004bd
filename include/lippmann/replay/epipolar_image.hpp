// Epipolar-plane images: one line of the display plane, seen by a row of eyes across the viewing zone.
//
// Based on: Bolles, Baker and Marimont, "Epipolar-plane image analysis: an approach to determining structure from motion", Int.
// J. Computer Vision 1, 1987. A scene point draws a straight line in the image. At depth z, its position on the display plane
// moves by -z / (1 - z / V) times the change of the eye's slope, with V the viewing distance. Lines of points in the display
// plane are vertical; points in front and behind lean to opposite sides.
#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "lippmann/replay/taps.hpp"

namespace lippmann {

/// Returns the epipolar-plane image of a row of the lens grid; rows count from the top. Each column of the image is a lens of
/// the row, each row an eye. The view_counts(optics).x eyes are equally spaced, with the leftmost on top. With whole pixels per
/// lens, the result holds the panel's own pixels. Throws a usage Error naming `epi` if the display has no such row. Returns
/// early, with an unfinished image, if `context` is cancelled.
Image epipolar_row(const RenderedPanel& rendered, int row, SampleFilter filter, const Context& context = {});

/// Returns the epipolar-plane image of a column of the lens grid. Each row is a lens of the column, each column an eye, the
/// lowest on the left. Throws a usage Error naming `epi-column` if the display has no such column or no vertical parallax.
Image epipolar_column(const RenderedPanel& rendered, int column, SampleFilter filter, const Context& context = {});

}  // namespace lippmann
