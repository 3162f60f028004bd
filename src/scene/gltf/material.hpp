#pragma once

#include <array>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"

namespace lippmann::gltf {

struct MaterialNeeds {
  std::array<int, 2> uv_sets{0, -1};
  bool tangents = false;
};

struct MaterialTable {
  std::vector<MaterialNeeds> needs;
  /// Index of the material for primitives without a material. -1: not added yet.
  int default_material = -1;
};

MaterialTable read_materials(Document& document, Scene& scene);

/// Returns the Scene's material index for a material index of the file. -1 in the file means glTF's default material.
int material_of(int file_material, MaterialTable& table, Scene& scene);

}  // namespace lippmann::gltf
