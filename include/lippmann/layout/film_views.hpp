// Extracts views, as a light field, and the panel's picture from a rendered film in memory.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the views of a film with the cameras of its optics (none for lenses viewed from infinity, whose views are parallel
/// projections). The stack holds the film's samples: linear light, 3 channels. `depth`: Aov::kDepth of the same frame. Throws
/// Error for optics without views of whole pixels (slanted or hexagonal lenses, calibrated panels), and for images whose size
/// differs from the panel's.
LightField light_field_of(const Image& film, const Optics& optics, const Image* depth = nullptr);

/// Returns the views of a layer of the same frame (FrameAovs), with any number of channels, as a stack. Throws under the same
/// conditions.
Image views_of_layer(const Image& layer, const Optics& optics);

/// Returns the panel's picture of a film, picture_size(optics) pixels: the film itself, or for a slanted panel, whose film has
/// one pixel per sub-pixel, the assembled whole pixels. Throws Error if the film's size differs from film_size.
Image picture_of_film(const Image& film, const Optics& optics);

/// Returns the panel's picture of a layer. For a slanted panel each pixel takes the value at its middle sub-pixel.
Image picture_of_layer(const Image& layer, const Optics& optics);

}  // namespace lippmann
