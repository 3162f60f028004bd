// Develops a traced frame into a picture: applies tone, undoes crosstalk, and arranges the pixels in the layout.
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
  const Optics& optics;  ///< optics of the film
  Tone tone = {};
  Encoding encoding = Encoding::kSrgb;           ///< encoding of the scene's values
  std::optional<double> crosstalk_to_undo = {};  ///< a sigma in the optics' pixels or views (optics/crosstalk.hpp)
  bool keeps_light = false;                      ///< keeps linear light, without tone mapping, premultiplied by alpha
};

/// Develops the film and the layers in place, but does not convert them to codes. If the picture needs a new buffer, returns
/// the film's old buffer; otherwise returns an empty image.
Image develop_frame(const Development& development, RenderedFrame& rendered);

}  // namespace lippmann
