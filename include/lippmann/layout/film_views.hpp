// The views of a film that has just been rendered, as a light field: what formats write and programs of vision research want;
// and the picture that a panel shows of it.
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

/// A layer of the same frame (FrameAovs), of any number of channels, as a stack of the same views. Throws likewise.
Image views_of_layer(const Image& layer, const Optics& optics);

/// What the panel shows of a film, picture_size(optics) pixels: the film itself, or whole pixels of a slanted panel, whose film
/// has one for each sub-pixel. Throws Error where the film is not of the panel's size.
Image picture_of_film(const Image& film, const Optics& optics);

/// The same of a layer: of a slanted panel's pixel, what is behind its middle sub-pixel.
Image picture_of_layer(const Image& layer, const Optics& optics);

}  // namespace lippmann
