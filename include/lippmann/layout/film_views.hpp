// Extracts views, as a light field, and the panel's picture from a rendered film in memory.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the views of a film (linear light, 3 channels) and the cameras of its optics. Lenses viewed from infinity have no
/// cameras. `depth` is Aov::kDepth of the same frame. Throws Error for optics whose views do not consist of whole pixels
/// (slanted or hexagonal lenses, calibrated panels), and for images whose size differs from the film's.
LightField light_field_of(const Image& film, const Optics& optics, const Image* depth = nullptr);

/// Replaces the cameras of views by their poses in the world (LightField::poses), and converts the depth to z in each camera's
/// frame. Lengths become thousandths of the world's unit. `origin` is added to the positions. world_from_display must be a
/// similarity. Throws Error if the cameras are unknown.
void place_in_world(LightField& field, const Affine3f& world_from_display, const Vec3d& origin);

/// Returns a vertical stack of the views of a layer (FrameAovs), with any number of channels. Throws Error for the same optics
/// and images as light_field_of().
Image views_of_layer(const Image& layer, const Optics& optics);

/// Returns the panel's picture of a film. Three pixels of a slanted panel's film, one per sub-pixel, make one pixel of the
/// picture. Throws Error if the film's size differs from film_size().
Image picture_of_film(const Image& film, const Optics& optics);

/// Like picture_of_film(), but for an extra layer such as depth. For a slanted panel, each pixel takes the value of its middle
/// sub-pixel.
Image picture_of_layer(const Image& layer, const Optics& optics);

}  // namespace lippmann
