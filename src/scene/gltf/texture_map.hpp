#pragma once

#include <array>
#include <functional>

#include "scene/gltf/texture.hpp"

namespace lippmann::gltf {

/// Reads a textureInfo, or returns an empty map if it is absent. The map's uv_set is the file's TEXCOORD number until
/// choose_uv_sets() changes it. `srgb` is true for colours and false for data.
TextureMap read_map(Value info, bool srgb, TextureReader& textures);

TextureMap read_map_from(Value info, const std::function<int(int)>& read);

/// Chooses the TEXCOORD numbers that become Mesh::uvs and Mesh::uvs_1, and sets uv_set in all maps of the surface. Returns the
/// two numbers; -1: none. If the maps use more than two sets, warns, and maps of the remaining sets use the first set.
std::array<int, 2> choose_uv_sets(MetallicRoughness& surface, const std::string& where, Report& report);

}  // namespace lippmann::gltf
