// What an eye sees through a lens array that lies on a rendered picture.
//
// The view is what passes through the display's window in the plane z = 0 (optics/viewing.hpp), as an eye that looks at the
// display has it before it: pixel (i, j) is a point of that plane, wherever the eye stands, so that views from different eyes
// lie on top of one another where the scene is in that plane. Linear light. What lies beside the panel is black.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/replay/eye_sampler.hpp"

namespace lippmann {

struct EyeView {
  Vec3d eye_mm{0.0, 0.0, 500.0};                ///< in the display frame; z > 0
  Vec2i size{0, 0};                             ///< pixels; 0: natural_view_size (optics/viewing.hpp)
  SampleFilter filter = SampleFilter::kLinear;  ///< between panel pixels below one lens, and views of a quilt
  double crosstalk_px = 0.0;  ///< a lens images the panel with a Gaussian of this sigma, in panel pixels (of a quilt: views);
                              ///< it takes the place of `filter` across the lenses. 0 ... kMaxBlurPx
  double pupil_mm = 0.0;      ///< diameter. 0: a pinhole
  double focus_mm = 0.0;      ///< the depth that the pupil is focused on, below the eye's; 0: the display
  int pupil_points = 64;      ///< their views are averaged; spread evenly over the pupil (a sunflower's spiral)
};

/// Throws Error (usage) for an eye that is not in front of the display, is not finite, or sees nothing of it.
void validate(const EyeView& view);

/// `view` must be valid. The same bits for any number of threads. Returns early, unfinished, when `context` is cancelled.
Image eye_view(const RenderedPanel& rendered, const EyeView& view, const ThreadPool& pool, const Context& context = {});

}  // namespace lippmann
