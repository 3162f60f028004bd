// Turns glTF materials into MetallicRoughness surfaces.
#pragma once

#include <vector>

#include "scene/gltf/document.hpp"
#include "scene/scene.hpp"

namespace lippmann::gltf {

/// What meshes have to know of materials.
struct MaterialTable {
  std::vector<int> uv_set;    ///< by material: which TEXCOORD_n its textures use
  int default_material = -1;  ///< of primitives that name none; added to the Scene on first use
};

/// Fills scene.materials, with the file's indices, and scene.textures.
MaterialTable read_materials(Document& document, Scene& scene);

/// The Scene's material of a primitive; -1 in the file means glTF's default.
int material_of(int file_material, MaterialTable& table, Scene& scene);

}  // namespace lippmann::gltf
