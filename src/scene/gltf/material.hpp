// Reads glTF materials as MetallicRoughness surfaces.
#pragma once

#include <array>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

/// The mesh attributes that a material needs.
struct MaterialNeeds {
  std::array<int, 2> uv_sets{0, -1};  ///< the n of the TEXCOORD_n for Mesh::uvs and uvs_1; -1: none
  bool tangents = false;
};

struct MaterialTable {
  std::vector<MaterialNeeds> needs;  ///< by material
  int default_material = -1;         ///< material of primitives without one; added to the Scene on first use
};

/// Fills scene.materials, in the file's order, and scene.textures.
MaterialTable read_materials(Document& document, Scene& scene);

/// Returns the Scene's material for a primitive; -1 in the file means glTF's default material.
int material_of(int file_material, MaterialTable& table, Scene& scene);

}  // namespace lippmann::gltf
