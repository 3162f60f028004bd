// The colour beside a sample: what lies at the pixel's own place when the point that landed on it has landed off its centre.
//
// A directional view of a lens array has one sample per lens, so that a point lands up to half a lens beside the next sample.
// Taking its colour as it is (the paper's rounding) is where most of an in-between frame's error comes from. But the other
// views of the same panel row have sampled the same surface at other places: seen from depth z they lie z m/g to the side, view
// by view (the lines of the epipolar plane image). Hence, where the colour changes beside the sample:
//   1. The place that the pixel shows lies -d beside the sample, d the landing's offset in lenses. The layer: the nearer to the
//      viewer of the sample and of its neighbour on that side in the same view.
//   2. Among the views up to `kViews` to either side: the sample nearest to the place on its left, and the one on its right, as
//      if all of them lay at the layer's depth; a view further away counts as farther away, because highlights and mirrors
//      change with the direction.
//   3. Each of these two is looked at. On the layer's object: its true place decides. Behind it, while the layer's edge is
//   here:
//      it shows that the layer has ended, and stands for the colour behind. In front: it tells nothing.
//   4. Linear interpolation between the nearest place left and right, the view's own two samples included.
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
  /// Whether views and samples are regular enough: whole pixels per lens.
  static bool suits(const Optics& optics);

  /// `optics` must suit. `encoding`: how the film becomes a picture, and thus which differences are seen.
  EpipolarSampler(const Optics& optics, Encoding encoding);

  /// Fills image.contrast.
  void find_contrast(PointImage& image, const ThreadPool& pool) const;

  /// Interpolated colours (three floats each) for points that landed on pixels after `motion`, given by their source pixels in
  /// `image`. Thread-safe.
  void colors(const PointImage& image, const Motion& motion, std::span<const std::uint32_t> sources, float* colors) const;

 private:
  GridLanding grid_;
  bool linear_film_;
};

}  // namespace lippmann
