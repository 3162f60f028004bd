// Builds the node hierarchy of a glTF file's default scene.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/move_origin.hpp"

namespace lippmann::gltf {

/// How the nodes of the file and those of the Scene correspond.
struct NodeMap {
  std::vector<int> file_node;              ///< by node of the Scene: parents before children, siblings in the file's order
  std::vector<int> scene_node;             ///< by node of the file; -1: not in the default scene
  std::vector<Affine3d> parent_from_node;  ///< by node of the Scene, as exact as the file has it
  std::vector<bool> hidden;                ///< by node of the Scene: it or a node above it is not visible (KHR_node_visibility)
};

/// The scene of a file that is read; the file has one or more.
std::size_t chosen_scene(const Document& document);

/// Fills scene.nodes. Warns about a scene that lists nodes which are no roots. Throws Error where a node has two parents, is
/// its own ancestor or has no proper transform.
NodeMap read_nodes(Document& document, Scene& scene);

}  // namespace lippmann::gltf
