// Reads the surroundings that a glTF scene has by EXT_lights_image_based.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Gives the scene a panorama of the cube map that its scene in the file refers to, if it refers to one. Warns about images
/// that are missing or of an unknown format, and leaves the surroundings out. Throws Error naming the image where one is
/// damaged, is not square, or has another size than the others.
void read_image_light(Document& document, Scene& scene);

}  // namespace lippmann::gltf
