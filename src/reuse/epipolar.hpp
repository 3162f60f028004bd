// Interpolates the colour at a pixel's centre if the point that landed on the pixel is off-centre.
//
// A directional view of a lens array has one sample per lens, so a point may land up to half a lens away from the nearest
// sample. Using the point's colour unchanged, as the paper does (see average.hpp), causes most of the error of in-between
// frames. The other views of the same panel row have sampled the same surface at other positions. At depth z, the samples shift
// by z m/g from view to view, with m the width of a pixel and g the gap between pixels and lenses (lines of the epipolar-plane
// image). If the colour changes next to the sample, the colour is interpolated:
//   1. A sample is one pixel of a view, and belongs to one lens. Let d be the offset of the projected point from the centre of
//      its sample, in lenses. The colour is wanted at the centre, which lies at -d from the point.
//   2. Choose the layer, which is the surface that the pixel shows. It is the surface of the sample, or of the neighbouring
//      sample of the same view on the side of -d, whichever is nearer to the viewer.
//   3. Among up to `kViews` views on each side, find the nearest samples to the left and to the right of the position. Assume
//      the layer's depth for all samples. Distant views get a penalty, because highlights and mirror images change with the
//      direction.
//   4. Look up both samples. If a sample lies on the layer's object, its own depth replaces the assumed one. A sample behind
//   the layer, near the edge of
//      the layer, shows that the layer has ended; it gives the colour behind the layer. A sample in front of the layer is
//      ignored.
//   5. Interpolate linearly between the nearest sample to the left and the nearest sample to the right. The two samples of the
//      pixel's own view are also candidates.
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

  /// `optics` must satisfy suits(). `encoding` is the encoding of the output image, which decides which colour differences are
  /// visible.
  EpipolarSampler(const Optics& optics, Encoding encoding);

  /// Sets image.contrast: marks each pixel whose colour differs from that of a neighbouring sample of its view.
  void find_contrast(PointImage& image, const ThreadPool& pool) const;

  /// Computes interpolated colours for landed points. `sources` holds the source pixel of each point in `image`. `colors`
  /// receives three floats per point. Thread-safe.
  void colors(const PointImage& image, const Motion& motion, std::span<const std::uint32_t> sources, float* colors) const;

 private:
  GridLanding grid_;
  bool linear_film_;
};

}  // namespace lippmann
