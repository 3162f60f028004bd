// Reads glTF materials as MetallicRoughness surfaces.
#pragma once

#include <array>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// The mesh attributes that a material uses.
struct MaterialNeeds {
  std::array<int, 2> uv_sets{0, -1};  ///< TEXCOORD numbers that become Mesh::uvs and Mesh::uvs_1; -1: none
  bool tangents = false;
};

struct MaterialTable {
  std::vector<MaterialNeeds> needs;  ///< one per material of the file
  /// Index of the material of primitives that have none; it is added to the Scene when it is first needed. -1: not added yet.
  int default_material = -1;
};

/// Sets scene.materials, in the order of the file, and scene.textures.
MaterialTable read_materials(Document& document, Scene& scene);

/// Returns the Scene's material index for a material index of the file. -1 in the file means glTF's default material.
int material_of(int file_material, MaterialTable& table, Scene& scene);

}  // namespace lippmann::gltf
