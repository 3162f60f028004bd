// Makes views of images with depth from other eye positions, to show RGB-D images on displays.
//
// The eye of the source has slope e = eye / D from the middle of its screen, with D the distance of the eye. A point that the
// source shows at s with disparity q(z) = z / (1 - z / D) appears to an eye of slope e' at
//   t = s - (e' - e) q
// on a screen of the same size. This is exact, since both eyes look through the same rectangle from distance D. On a screen k
// times as large, t, s and q are k times as large. Displays with another viewing distance show the same disparity per slope.
//
// Each view is made in three steps:
//   1. Forward: the points are splatted with a z-buffer. Points between neighbours of one surface are interpolated to avoid
//      cracks.
//   2. Missed pixels: the nearest pixels with a point are found in the same row, or in the same column if the row has none. The
//      surface that is farther from the viewer is continued (the rule of reuse/missed.hpp).
//   3. Backward: each pixel with a point takes its colour from where the source shows that point, by bilinear interpolation
//      among pixels of the same surface.
#pragma once

#include <span>

#include "lippmann/core/parallel.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct DepthViews {
  LightField field;           ///< the views, in linear light, with cameras and depth
  double filled_share = 0.0;  ///< share of all pixels that had no point and were filled
};

/// Makes views from one image. source: one view with depth and camera. optics: optics with views (a quilt, a camera grid). The
/// image fills the window of the views and is cropped to the window's shape. depth_scale multiplies all depths. The result does
/// not depend on the number of threads. Throws Error if the views of the optics have no cameras.
DepthViews views_from_depth(const LightField& source, const Optics& optics, double depth_scale, const ThreadPool& pool);

/// Makes views from one or more images with different eye positions. Each view is made from the source with the nearest eye.
/// Pixels without a point are then taken from the other sources, and filled if no source has a point there.
DepthViews views_from_depths(std::span<const LightField> sources, const Optics& optics, double depth_scale,
                             const ThreadPool& pool);

}  // namespace lippmann
