// Reads nodes that show several copies of their mesh (EXT_mesh_gpu_instancing).
#pragma once

#include <vector>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

inline constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// Adds a child of `scene_node` for every copy and returns the children's indices. Throws Error at the file's node.
std::vector<int> read_places(Document& document, int file_node, int scene_node, Scene& scene);

}  // namespace lippmann::gltf
