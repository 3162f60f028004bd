// Reads the lamps of a glTF file whose light was measured (EXT_lights_ies).
#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Adds to scene.lights, in the order of the Scene's nodes, and their webs to scene.webs, each once. A lamp whose profile is
/// missing is left out with a warning; a profile that is damaged is an Error.
void read_ies_lights(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace lippmann::gltf
