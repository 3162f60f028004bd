// Builds the node hierarchy of a glTF file's default scene.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// How the nodes of the file and those of the Scene correspond.
struct NodeMap {
  std::vector<int> file_node;   ///< by node of the Scene: parents before children, siblings in the file's order
  std::vector<int> scene_node;  ///< by node of the file; -1: not in the default scene
};

/// Whether the node's `extras` have false of that name, or 0, which Blender has in its place.
bool denies(const tinygltf::Node& node, const char* name);

/// Fills scene.nodes. Throws Error where a node has two parents, is its own ancestor or has no proper transform.
NodeMap read_nodes(Document& document, Scene& scene);

}  // namespace lippmann::gltf
