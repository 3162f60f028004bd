// The screen that shows a job's images. The array is fitted to the scene with the screen's aspect; the optics are then made
// from the fitted array.
#pragma once

#include <functional>

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// Made from a job's parameters (screen_of_params.hpp), from a display (screen_of_display.hpp), or for two eyes
/// (screen_for_stereo.hpp).
struct Screen {
  float window_aspect = 1.0f;  ///< width / height of the visible part of the display plane: the panel, or one view of a quilt

  /// Returns the optics for an array that was fitted with this aspect. Throws a usage Error if no optics exist for the array's
  /// viewer.
  std::function<Optics(const FittedArray&)> optics;

  /// The viewer stays where it was fitted, and the optics decide how much of the scene they see: cameras.
  bool keeps_viewer = false;
};

}  // namespace lippmann
