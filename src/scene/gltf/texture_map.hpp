// Reads the texture references of glTF materials.
#pragma once

#include <array>
#include <functional>

#include "scene/gltf/texture.hpp"

namespace lippmann::gltf {

/// Reads a textureInfo; returns an empty map if it is absent. The map's uv_set is still the n of TEXCOORD_n in the file. srgb:
/// true for colours, false for data.
TextureMap read_map(Value info, bool srgb, TextureReader& textures);

/// Like read_map(), but with a function that returns the Scene's texture index for the file's.
TextureMap read_map_from(Value info, const std::function<int(int)>& read);

/// Returns the n of the TEXCOORD_n for Mesh::uvs and uvs_1 (-1: none) and renumbers the uv_set of the surface's maps. If the
/// maps use more than two sets, warns and uses the first set for the others.
std::array<int, 2> choose_uv_sets(MetallicRoughness& surface, const std::string& where, Report& report);

}  // namespace lippmann::gltf
