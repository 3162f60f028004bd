// A rendered light field as it lies behind its lenses: the picture on the panel, and the optics that it was rendered for.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct RenderedPanel {
  Optics optics;
  Image picture;  ///< 3 channels, linear; as large as picture_size(optics) says
};

/// Throws Error where the picture is not of the panel: another size, other channels or fewer samples. All that looks at a panel
/// calls it.
void validate(const RenderedPanel& rendered);

}  // namespace lippmann
