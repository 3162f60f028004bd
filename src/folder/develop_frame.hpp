// Develops a traced frame into a picture: applies the tone curve, corrects crosstalk, and arranges the pixels in the
// layout.
#pragma once

#include <optional>

#include "folder/frame_layout.hpp"
#include "lippmann/frames/rendered_frame.hpp"
#include "lippmann/image/encoding.hpp"
#include "lippmann/image/tone.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct Development {
  const FrameLayout& layout;
  const Optics& optics;
  Tone tone = {};
  Encoding encoding = Encoding::kSrgb;  ///< encoding of the scene's values
  /// Crosstalk to correct: the standard deviation of the Gaussian blur (optics/crosstalk.hpp), in pixels, or in views
  /// for a quilt.
  std::optional<double> crosstalk_to_undo = {};
  /// Whether the picture holds linear light, premultiplied by alpha, without tone mapping.
  bool keeps_light = false;
};

/// Develops the film and the layers in place, as floats. Returns the old buffer of the film if the picture needs a new
/// one, otherwise an empty image.
Image develop_frame(const Development& development, RenderedFrame& rendered);

}  // namespace lippmann
