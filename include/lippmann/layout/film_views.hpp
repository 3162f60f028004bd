// The views of a film that has just been rendered, as a light field: what formats write and programs of vision research want.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// The views of a film as its optics lie, with their cameras where these are pinholes (not those of lenses that are seen from
/// infinity). The stack has the film's samples: linear light, 3 channels. `depth`, where given: Aov::kDepth of the same frame.
/// Throws Error for optics without views of whole pixels (slanted or hexagonal lenses, calibrated panels), and for images that
/// are not of the panel's size.
LightField light_field_of(const Image& film, const Optics& optics, const Image* depth = nullptr);

}  // namespace lippmann
