// Reads the lights of a glTF file (KHR_lights_punctual), and lights scenes that have none.
#pragma once

#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"
#include "scene/scene.hpp"

namespace lippmann::gltf {

/// Fills scene.lights, in the order of the Scene's nodes. Candela and lux are taken as they are.
void read_lights(Document& document, const NodeMap& nodes, Scene& scene);

/// Gives a scene that has surfaces to light but no lights a key light from above left of the viewer and a dim background, with
/// a warning. The viewer is the first camera at rest, or has the default view. Call after read_cameras().
void add_default_light(Document& document, Scene& scene);

}  // namespace lippmann::gltf
