// Computes what an eye sees of a rendered panel through its lens array.
//
// The view covers the display's window in the plane z = 0 (optics/viewing.hpp), seen from the viewer's side. Pixel (i, j) is
// the same point of that plane for every eye, so scene points in the plane keep their pixel when the eye moves. Colours are
// linear. Points beside the panel are black.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/replay/eye_sampler.hpp"

namespace lippmann {

struct EyeView {
  Vec3d eye_mm{0.0, 0.0, 500.0};                ///< position of the eye in the display frame; z > 0
  Vec2i size{0, 0};                             ///< size of the image in pixels; 0: natural_view_size() (optics/viewing.hpp)
  SampleFilter filter = SampleFilter::kLinear;  ///< how pixels below one lens, and views of a quilt, are interpolated
  /// Standard deviation of the Gaussian with which a lens blurs the panel, in panel pixels (quilt: in views), 0 ... kMaxBlurPx.
  /// If it is not 0, the Gaussian replaces `filter` across the lenses.
  double crosstalk_px = 0.0;
  double pupil_mm = 0.0;  ///< diameter of the pupil; 0: a pinhole
  double focus_mm = 0.0;  ///< z of the plane on which the eye focuses, less than the eye's z; 0: the display
  /// Number of points of the pupil, spread evenly in a sunflower spiral. The result is the mean of the views from these points.
  int pupil_points = 64;
};

/// Throws a usage Error if the eye is not in front of the display or not finite, or if another value is out of range.
void validate(const EyeView& view);

/// Returns the view of an eye. `view` must be valid. The result does not depend on the number of threads. Returns early, with
/// an unfinished image, if `context` is cancelled.
Image eye_view(const RenderedPanel& rendered, const EyeView& view, const ThreadPool& pool, const Context& context = {});

}  // namespace lippmann
