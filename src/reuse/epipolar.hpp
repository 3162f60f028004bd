// Interpolates the colour at a pixel's centre if the point that landed on the pixel is off-centre.
//
// A view of a lens array has one sample per lens, so a point may land up to half a lens away from the nearest sample. The other
// views of the panel row have sampled the same surface at other positions. At depth z, the samples shift by z m/g from view to
// view (lines of the epipolar-plane image), where m is the width of a pixel and g the gap between pixels and lenses. Colours
// that change next to the sample are interpolated:
//   1. A sample is one pixel of a view, and belongs to one lens. Let d be the offset of the projected point from the centre of
//      its sample, in lenses. The colour is wanted at -d from the point.
//   2. Of the sample's surface and the surface of the next sample on the side of -d, take the surface nearer to the viewer.
//   3. In up to `kViews` views on each side, find the nearest samples to the left and to the right of the wanted position,
//      assuming the depth of that surface. Distant views get a penalty, because highlights change with direction.
//   4. Replace the assumed depth by a sample's own depth if the sample lies on the same object. A sample farther from the
//      viewer gives the colour behind the surface's edge. Ignore samples nearer to the viewer.
//   5. Interpolate linearly between the nearest sample to the left and the nearest to the right, including those of the own
//      view.
//
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
  /// Returns whether the optics have regular samples, which requires a whole number of pixels per lens.
  static bool suits(const Optics& optics);

  /// `optics` must satisfy suits(). `encoding` is that of the output image; it decides which colour differences are visible.
  EpipolarSampler(const Optics& optics, Encoding encoding);

  /// Sets image.contrast: marks each pixel whose colour differs from that of a neighbouring sample of its view.
  void find_contrast(PointImage& image, const ThreadPool& pool) const;

  /// Computes the interpolated colour of each point that landed on another pixel. `sources` holds the pixels of the points in
  /// `image`. `colors` gets three floats per point. Thread-safe.
  void colors(const PointImage& image, const Motion& motion, std::span<const std::uint32_t> sources, float* colors) const;

 private:
  GridLanding grid_;
  bool linear_film_;
};

}  // namespace lippmann
