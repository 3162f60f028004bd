// A rendered light field as it lies behind its lenses: the picture on the panel, and the optics that it was rendered for.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct RenderedPanel {
  Optics optics;
  Image picture;  ///< 3 channels, linear; of picture_size(optics)
};

/// The pixels of the picture that a panel shows: its own; of a slanted panel, each of three sub-pixels.
inline Vec2i picture_size(const Optics& optics) {
  return {optics.panel.width / sub_pixels_per_pixel(optics), optics.panel.height};
}

}  // namespace lippmann
