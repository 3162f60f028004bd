// A rendered light field behind its lenses: the image on the panel and the optics that it was rendered for.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct RenderedPanel {
  Optics optics{};
  Image picture{};  ///< linear, of the size picture_size(optics)
};

/// Throws Error if the picture does not match the panel in size, channels or number of samples.
void validate(const RenderedPanel& rendered);

}  // namespace lippmann
