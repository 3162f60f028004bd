#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Appends the lights to scene.lights, in the order of the Scene's nodes, and each profile once to scene.webs. If a profile's
/// file is missing, warns and skips its lights. Throws Error for an invalid profile.
void read_ies_lights(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace lippmann::gltf
