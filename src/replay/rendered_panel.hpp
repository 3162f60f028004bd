// A rendered light field as it lies behind its lenses: the picture on the panel, and the optics that it was rendered for.
#pragma once

#include "image/image.hpp"
#include "optics/optics.hpp"

namespace lippmann {

struct RenderedPanel {
  Optics optics;
  Image picture;  ///< 3 channels, linear; the panel's size
};

}  // namespace lippmann
