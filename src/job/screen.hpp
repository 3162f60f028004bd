// The screen that a job's images are for. Fitting the array to the scene needs its aspect, and making its optics needs the
// fitted array.
#pragma once

#include <functional>

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// Made from a job's parameters (screen_of_params.hpp), from a display (screen_of_display.hpp), or for two eyes
/// (screen_for_stereo.hpp).
struct Screen {
  float window_aspect = 1.0f;  ///< width / height of the visible part of the display plane: the panel, or one view of a quilt

  /// Returns the optics for the viewer of an array fitted with this aspect. Throws a usage Error if there are none for this
  /// viewer.
  std::function<Optics(const FittedArray&)> optics;

  /// The viewer stays where it was fitted, and the optics decide how much of the scene they see: cameras.
  bool keeps_viewer = false;
};

}  // namespace lippmann
