#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Sets scene.cameras, in the order of the Scene's nodes. The Scene's instances must have been read before.
void read_cameras(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace lippmann::gltf
