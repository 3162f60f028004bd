// Reads the lights of a glTF file (KHR_lights_punctual).
#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Fills scene.lights in the order of the Scene's nodes. Candela and lux become radiometric units unchanged, except in files
/// from Blender's exporter, where they are converted back to watts.
void read_lights(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace lippmann::gltf
