// Reads glTF lights with measured light profiles (EXT_lights_ies).
#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Appends to scene.lights in the order of the Scene's nodes, and adds each profile once to scene.webs. Skips lamps without a
/// profile file, with a warning. Throws Error for a malformed profile.
void read_ies_lights(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace lippmann::gltf
