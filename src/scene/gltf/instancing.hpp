#pragma once

#include <vector>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

inline constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

std::vector<int> read_places(Document& document, int file_node, int scene_node, Scene& scene);

}  // namespace lippmann::gltf
