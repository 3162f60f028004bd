// Computes what an eye sees of a rendered panel through its lens array.
//
// The view covers a fixed rectangle in the display plane z = 0, the window of optics/viewing.hpp. Each pixel of the view shows
// the same point of this plane for every eye. Colours are linear. Points beside the panel are black.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/replay/eye_sampler.hpp"

namespace lippmann {

struct EyeView {
  Vec3d eye_mm{0.0, 0.0, 500.0};                ///< in the display frame; z > 0
  Vec2i size{0, 0};                             ///< in pixels; 0: natural_view_size() (optics/viewing.hpp)
  SampleFilter filter = SampleFilter::kLinear;  ///< interpolation of pixels below one lens, or of views of a quilt
  /// Standard deviation of the Gaussian with which a lens blurs the panel, in panel pixels (quilt: in views), 0 ... kMaxBlurPx.
  /// If above 0, the Gaussian replaces `filter` in the directions in which the lenses separate pixels.
  double crosstalk_px = 0.0;
  double pupil_mm = 0.0;  ///< diameter of the pupil; 0: a pinhole
  double focus_mm = 0.0;  ///< z of the plane on which the eye focuses; 0: the display
  /// The result is the mean of the views from this many points of the pupil.
  int pupil_points = 64;
};

/// Throws a usage Error if the eye is not in front of the display, or if a value is out of range.
void validate(const EyeView& view);

/// `view` must be valid. The image is unfinished if `context` is cancelled.
Image eye_view(const RenderedPanel& rendered, const EyeView& view, const ThreadPool& pool, const Context& context = {});

}  // namespace lippmann
