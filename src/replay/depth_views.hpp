// Views of a picture whose depth is known, from other places than the one it was seen from: what shows RGB-D pictures on
// displays.
//
// A point that the source, whose eye is at slope e = eye / D from the middle of its screen, shows at s on it with the disparity
// q(z) = z / (1 - z / D) is seen by an eye of slope e' at
//   t = s - (e' - e) q
// on a screen of the same size: exactly, as both look through the same rectangle from the distance D. On a screen k times as
// large t, s and q are k times as large; displays that are seen from elsewhere show the same disparity per slope.
//
// Each view is made in three steps. Forward: the points fall on pixels, and of those on one pixel the nearest wins (z-buffer);
// between neighbours of one surface points are interpolated, so that it has no cracks. Missed pixels: where none falls, the
// surface to either side, of the nearest neighbours along the row (else along the column) the one farther from the viewer
// (reuse/missed.hpp has the same rule). Backward: a pixel that has a point takes its colour from where the source shows that
// point, bilinear among pixels of its surface.
#pragma once

#include <span>

#include "lippmann/core/parallel.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct DepthViews {
  LightField field;           ///< the views of the optics, linear light, with cameras and depth
  double filled_share = 0.0;  ///< the share of all pixels that no point has fallen on
};

/// `source`: one view with depth and camera. `optics`: those of views (a quilt, a camera grid); the picture fills their window,
/// and what has another shape is cut off. `depth_scale` times as deep as it is. The same bits for any number of threads. Throws
/// Error for optics whose views have no cameras.
DepthViews views_from_depth(const LightField& source, const Optics& optics, double depth_scale, const ThreadPool& pool);

/// The same of pictures that were seen from several places, one or more: each view takes the nearest one, and the others where
/// that one shows nothing, before missed pixels are filled.
DepthViews views_from_depths(std::span<const LightField> sources, const Optics& optics, double depth_scale,
                             const ThreadPool& pool);

}  // namespace lippmann
