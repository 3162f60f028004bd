// Extracts views, as a light field, and the panel's picture from a rendered film in memory.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the views of a film and the cameras of its optics. Lenses viewed from infinity have no cameras, because their views
/// are parallel projections. The stack holds the film's samples: linear light, 3 channels. `depth`: Aov::kDepth of the same
/// frame. Throws Error for optics whose views do not consist of whole pixels (slanted or hexagonal lenses, calibrated panels),
/// and for images whose size differs from the film's.
LightField light_field_of(const Image& film, const Optics& optics, const Image* depth = nullptr);

/// Returns the views of a layer (FrameAovs), with any number of channels, as a stack. Throws Error as light_field_of().
Image views_of_layer(const Image& layer, const Optics& optics);

/// Returns the panel's picture of a film, picture_size(optics) pixels. This is the film itself, except for a slanted panel: its
/// film has one pixel per sub-pixel, and three of them make one pixel of the picture. Throws Error if the film's size differs
/// from film_size().
Image picture_of_film(const Image& film, const Optics& optics);

/// Returns the panel's picture of a layer. For a slanted panel, each pixel takes the value of its middle sub-pixel.
Image picture_of_layer(const Image& layer, const Optics& optics);

}  // namespace lippmann
