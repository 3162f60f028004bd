// Interpolates the colour at a pixel's centre when the point that landed on the pixel is off-centre.
//
// A directional view of a lens array has one sample per lens, so a point lands up to half a lens away from the next sample.
// Using the point's colour unchanged, as the paper does, causes most of an in-between frame's error. But the other views of the
// same panel row have sampled the same surface at other positions. At depth z, the samples shift by z m/g from view to view
// (the lines of the epipolar plane image). If the colour changes beside the sample:
//   1. The pixel shows the place at -d from the sample's centre, where d is the offset of the projected point in lenses. The
//      layer is the sample or its neighbour on that side in the same view, whichever is nearer to the viewer.
//   2. Among up to `kViews` views on each side, find the samples nearest to the place on its left and on its right, assuming
//      the layer's depth for all of them. Distant views get a penalty, because highlights and mirrors change with the
//      direction.
//   3. Look up both samples. If a sample lies on the layer's object, use its true position. If it lies behind the layer, near
//      the layer's edge, it shows that the layer has ended, and stands for the colour behind. If it lies in front of the
//      layer, ignore it.
//   4. Interpolate linearly between the nearest places left and right, including the two samples of the pixel's
//      own view.
// Based on epipolar neighbours in light-field rendering (M. Levoy, P. Hanrahan, "Light field rendering", SIGGRAPH 1996; S. J.
// Gortler et al., "The Lumigraph", SIGGRAPH 1996, section 3.3, depth correction).
#pragma once

#include <cstdint>
#include <span>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/encoding.hpp"
#include "lippmann/optics/optics.hpp"
#include "reuse/make_landing.hpp"
#include "reuse/motion.hpp"
#include "reuse/point_image.hpp"

namespace lippmann {

class EpipolarSampler {
 public:
  /// Returns whether the views and samples are regular enough, which takes whole pixels per lens.
  static bool suits(const Optics& optics);

  /// `optics` must satisfy suits(). `encoding` is that of the output image; it decides which differences are visible.
  EpipolarSampler(const Optics& optics, Encoding encoding);

  /// Fills image.contrast: marks pixels whose colour differs from the next samples of their view.
  void find_contrast(PointImage& image, const ThreadPool& pool) const;

  /// Computes interpolated colours (three floats each) for landed points, given by their source pixels in `image`. Thread-safe.
  void colors(const PointImage& image, const Motion& motion, std::span<const std::uint32_t> sources, float* colors) const;

 private:
  GridLanding grid_;
  bool linear_film_;
};

}  // namespace lippmann
