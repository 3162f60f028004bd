// A traced frame becomes what its picture shows: toned, crosstalk undone, its pixels where the layout wants them.
#pragma once

#include <optional>

#include "folder/frame_layout.hpp"
#include "image/tone.hpp"
#include "lippmann/frames/rendered_frame.hpp"
#include "lippmann/image/encoding.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct Development {
  const FrameLayout& layout;
  const Optics& optics;  ///< the film's
  Tone tone = {};
  Encoding encoding = Encoding::kSrgb;           ///< how the scene's values become codes
  std::optional<double> crosstalk_to_undo = {};  ///< a sigma in the optics' pixels or views (optics/crosstalk.hpp)
  bool keeps_light = false;                      ///< light stays as it is, without tone, and multiplied by alpha
};

/// Changes the film and the layers in their place; codes are not made. Returns the film's memory where the picture has another
/// one, else an empty image.
Image develop_frame(const Development& development, RenderedFrame& rendered);

}  // namespace lippmann
