// Reads the cameras of a glTF file.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Fills scene.cameras, in the order of the Scene's nodes. An orthographic camera becomes a perspective one that shows the same
/// height at the distance of the scene's centre, with a warning. Call when the Scene has its instances.
void read_cameras(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace lippmann::gltf
