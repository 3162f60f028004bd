#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/move_origin.hpp"

namespace lippmann::gltf {

struct NodeMap {
  std::vector<int> file_node;  ///< file node of each Scene node; parents precede their children
  std::vector<int> scene_node;
  std::vector<Affine3d> parent_from_node;
  std::vector<bool> hidden;
};

std::size_t chosen_scene(const Document& document);

/// Sets scene.nodes. Warns if the scene lists nodes that are not roots. Throws Error if a node has two parents, is its own
/// ancestor, or has an invalid transform.
NodeMap read_nodes(Document& document, Scene& scene);

}  // namespace lippmann::gltf
