// Builds the node hierarchy of a glTF file's default scene.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/move_origin.hpp"

namespace lippmann::gltf {

/// The correspondence between nodes of the file and nodes of the Scene.
struct NodeMap {
  std::vector<int> file_node;              ///< per Scene node: parents before children, siblings in file order
  std::vector<int> scene_node;             ///< per file node; -1: not in the default scene
  std::vector<Affine3d> parent_from_node;  ///< per Scene node, in double precision
  std::vector<bool> hidden;                ///< per Scene node: the node or an ancestor is invisible (KHR_node_visibility)
};

/// Returns the index of the scene to read. The file must have at least one.
std::size_t chosen_scene(const Document& document);

/// Fills scene.nodes. Warns if the scene lists nodes that are not roots. Throws Error if a node has two parents, is its own
/// ancestor, or has an invalid transform.
NodeMap read_nodes(Document& document, Scene& scene);

}  // namespace lippmann::gltf
