// Interpolates the colour at a pixel's centre when the point that landed on the pixel is off-centre.
//
// A directional view of a lens array has one sample per lens, so a point lands up to half a lens away from the next sample.
// Using the point's colour unchanged (the paper's rounding) causes most of an in-between frame's error. But the other views of
// the same panel row have sampled the same surface at other places: seen from depth z, these are shifted by z m/g per view (the
// lines of the epipolar plane image). If the colour changes beside the sample:
//   1. The place that the pixel shows is -d beside the sample, where d is the landing's offset in lenses. The layer is the
//      sample or its neighbour on that side in the same view, whichever is nearer to the viewer.
//   2. Among up to `kViews` views on each side, find the samples nearest to the place on its left and on its right, assuming
//      the layer's depth for all of them. Distant views get a penalty, because highlights and mirrors change with the
//      direction.
//   3. Look up both samples. On the layer's object, use the true position. Behind it, near the layer's edge, the sample shows
//      that the layer has ended, and stands for the colour behind. In front of it, ignore the sample.
//   4. Interpolate linearly between the nearest places left and right, including the view's own two samples.
// After the epipolar neighbours of light-field rendering (M. Levoy, P. Hanrahan, "Light field rendering", SIGGRAPH 1996; S. J.
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
  /// Returns whether the views and samples are regular enough: whole pixels per lens.
  static bool suits(const Optics& optics);

  /// `optics` must satisfy suits(). `encoding`: of the output image; decides which differences are visible.
  EpipolarSampler(const Optics& optics, Encoding encoding);

  /// Fills image.contrast.
  void find_contrast(PointImage& image, const ThreadPool& pool) const;

  /// Computes interpolated colours (three floats each) for landed points, given by their source pixels in `image`. Thread-safe.
  void colors(const PointImage& image, const Motion& motion, std::span<const std::uint32_t> sources, float* colors) const;

 private:
  GridLanding grid_;
  bool linear_film_;
};

}  // namespace lippmann
