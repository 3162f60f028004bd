// Reads the environment light of a glTF scene (EXT_lights_image_based).
#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Converts the scene's cube map, if any, to a panorama in scene.background. If an image is missing or of an unknown format,
/// warns and leaves out the environment. Throws Error naming the image if it is malformed, not square, or of a different size
/// than the others.
void read_image_light(Document& document, Scene& scene);

}  // namespace lippmann::gltf
