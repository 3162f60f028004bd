// The screen that shows a job's images. The lens array is fitted to the scene with the aspect of the screen. Then the optics
// are made from the fitted array.
#pragma once

#include <functional>

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// A Screen is made from parameters (screen_of_params.hpp), from a display (screen_of_display.hpp), or for two eyes
/// (screen_for_stereo.hpp).
struct Screen {
  /// Width / height of the panel, or of one view of a quilt.
  float window_aspect = 1.0f;

  /// Returns the optics for an array that was fitted with window_aspect. Throws a usage Error if no optics exist for
  /// the array's viewer.
  std::function<Optics(const FittedArray&)> optics;

  /// True for camera optics: the viewer stays at the fitted distance, and the optics decide how much of the scene is visible.
  bool keeps_viewer = false;
};

}  // namespace lippmann
