// Makes views of images with depth from other eye positions, to show RGB-D images on displays.
//
// Let e = eye / D be the slope of the source's eye from the middle of its screen, with D the distance of the eye. A point that
// the source shows at s with disparity q(z) = z / (1 - z / D) appears to an eye of slope e' at
//   t = s - (e' - e) q
// on a screen of the same size. On a screen k times as large, t, s and q are k times as large.
//
// Each view is made in three steps:
//   1. Forward: the points are splatted with a z-buffer. Points between neighbours of one surface are interpolated.
//   2. Missed pixels: the nearest pixels with a point are found in the same row, or in the same column if the row has none. The
//      surface that is farther from the viewer is continued (as in reuse/missed.hpp).
//   3. Backward: each pixel takes its colour from where the source shows its point, by bilinear interpolation on one surface.
#pragma once

#include <span>

#include "lippmann/core/parallel.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct DepthViews {
  LightField field;
  double filled_share = 0.0;  ///< fraction of pixels that had no point and were filled
};

/// `source` is one view with depth and camera. `optics` is a quilt or a camera grid. The image is cropped to the aspect ratio
/// of the display, which it then fills. Throws Error if the views of `optics` have no cameras.
DepthViews views_from_depth(const LightField& source, const Optics& optics, double depth_scale, const ThreadPool& pool);

/// Makes each view from the source with the nearest eye. Pixels without a point are taken from the other sources, or filled.
DepthViews views_from_depths(std::span<const LightField> sources, const Optics& optics, double depth_scale,
                             const ThreadPool& pool);

}  // namespace lippmann
