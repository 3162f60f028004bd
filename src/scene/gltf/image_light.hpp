#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Converts the scene's cube map, if it has one, to a panorama in scene.background. If an image is missing or has an unknown
/// format, warns and ignores the cube map. Throws Error naming the image if it is malformed, not square, or not of the same
/// size as the other images.
void read_image_light(Document& document, Scene& scene);

}  // namespace lippmann::gltf
