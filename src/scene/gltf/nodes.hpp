// Builds the node hierarchy of the default scene of a glTF file.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/move_origin.hpp"

namespace lippmann::gltf {

/// Maps nodes of the file to nodes of the Scene.
struct NodeMap {
  std::vector<int> file_node;              ///< file node of each Scene node; parents precede their children
  std::vector<int> scene_node;             ///< Scene node of each file node; -1: not in the default scene
  std::vector<Affine3d> parent_from_node;  ///< transform of each Scene node in double precision
  /// Whether each Scene node or one of its ancestors is invisible (KHR_node_visibility).
  std::vector<bool> hidden;
};

/// Returns the index of the default scene. The file must have at least one scene.
std::size_t chosen_scene(const Document& document);

/// Sets scene.nodes. Warns if the scene lists nodes that are not roots. Throws Error if a node has two parents, is its own
/// ancestor, or has an invalid transform.
NodeMap read_nodes(Document& document, Scene& scene);

}  // namespace lippmann::gltf
