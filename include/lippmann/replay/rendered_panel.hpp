// A rendered light field behind its lenses: the image on the panel and the optics that it was rendered for.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct RenderedPanel {
  Optics optics{};
  Image picture{};  ///< 3 channels, linear; its size is picture_size(optics)
};

/// Throws Error if the picture does not match the panel in size, channels or number of samples. All functions that take a
/// RenderedPanel call validate().
void validate(const RenderedPanel& rendered);

}  // namespace lippmann
