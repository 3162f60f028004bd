// Turns glTF materials into MetallicRoughness surfaces.
#pragma once

#include <array>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// Which attributes of a mesh a material looks at.
struct MaterialNeeds {
  std::array<int, 2> uv_sets{0, -1};  ///< TEXCOORD_n that become Mesh::uvs and uvs_1; -1: none
  bool tangents = false;
};

struct MaterialTable {
  std::vector<MaterialNeeds> needs;  ///< by material
  int default_material = -1;         ///< what primitives that name none get; added to the Scene on first use
};

/// Fills scene.materials, with the file's indices, and scene.textures.
MaterialTable read_materials(Document& document, Scene& scene);

/// The Scene's material of a primitive; -1 in the file means glTF's default.
int material_of(int file_material, MaterialTable& table, Scene& scene);

}  // namespace lippmann::gltf
