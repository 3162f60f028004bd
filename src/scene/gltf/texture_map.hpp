// Reads the texture references of glTF materials.
#pragma once

#include <array>
#include <functional>

#include "scene/gltf/texture.hpp"

namespace lippmann::gltf {

/// Reads a textureInfo; returns an empty map if it is absent. The map's uv_set is still the n of TEXCOORD_n in the file. srgb:
/// true for colours, false for data.
TextureMap read_map(Value info, bool srgb, TextureReader& textures);

/// Does the same with a custom function that maps the file's texture index to the Scene's.
TextureMap read_map_from(Value info, const std::function<int(int)>& read);

/// Chooses the TEXCOORD_n for Mesh::uvs and uvs_1 (-1: none) and renumbers the uv_set of the surface's maps. Warns about more
/// than two sets and uses the first instead.
std::array<int, 2> choose_uv_sets(MetallicRoughness& surface, const std::string& where, Report& report);

}  // namespace lippmann::gltf
