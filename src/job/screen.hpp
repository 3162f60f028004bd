// The screen that a job's pictures are for. Its aspect is needed to fit the array to the scene, and the fitted array to make
// its optics.
#pragma once

#include <functional>

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// Made of a job's parameters alone (screen_of_params.hpp), of a display (screen_of_display.hpp), or for two eyes
/// (screen_for_stereo.hpp).
struct Screen {
  float window_aspect = 1.0f;  ///< width / height of what is seen of the display plane: the panel, or one view of a quilt

  /// The optics for the viewer of the array that was fitted to the scene with this aspect. Throws a usage Error where there
  /// are none for this viewer.
  std::function<Optics(const FittedArray&)> optics;
};

}  // namespace lippmann
