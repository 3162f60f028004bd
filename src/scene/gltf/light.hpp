#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Sets scene.lights, in the order of the Scene's nodes. Values in candela and lux are used as radiometric values without
/// conversion, except that files from Blender's exporter are converted back to watts.
void read_lights(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace lippmann::gltf
