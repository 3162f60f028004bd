// Reads the cameras of a glTF file.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Fills scene.cameras in the order of the Scene's nodes. An orthographic camera also gets the field of view that shows its
/// height at the distance of the scene's centre. The Scene must have its instances.
void read_cameras(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace lippmann::gltf
