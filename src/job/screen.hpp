// The screen that shows a job's images. First the lens array is fitted to the scene with the aspect of the screen. Then the
// optics are made from the fitted array.
#pragma once

#include <functional>

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// A screen. screen_of_params.hpp makes it from a job's parameters, screen_of_display.hpp from a display, and
/// screen_for_stereo.hpp for two eyes.
struct Screen {
  /// Width / height of the visible rectangle in the display plane. The rectangle is the panel, or one view of a quilt.
  float window_aspect = 1.0f;

  /// Returns the optics for an array that was fitted with window_aspect. Throws a usage Error if no optics exist for the
  /// array's viewer.
  std::function<Optics(const FittedArray&)> optics;

  /// True for optics that are a camera (a sensor behind a lens): the viewer stays where it was fitted, and the optics decide
  /// how much of the scene is visible.
  bool keeps_viewer = false;
};

}  // namespace lippmann
