// Turns the texture references of glTF materials into TextureMaps.
#pragma once

#include <array>
#include <functional>

#include "scene/gltf/texture.hpp"

namespace lippmann::gltf {

/// Decodes the texture of a textureInfo; no map where it is absent. The map's uv_set is still the file's n of TEXCOORD_n. srgb:
/// its colours are encoded; false for data.
TextureMap read_map(Value info, bool srgb, TextureReader& textures);

/// The same where read(texture of the file) makes the Scene's.
TextureMap read_map_from(Value info, const std::function<int(int)>& read);

/// Which TEXCOORD_n become Mesh::uvs and uvs_1 (-1: none) for this surface; renumbers its maps' uv_set accordingly. Beyond two
/// sets: a warning, and the first one is used.
std::array<int, 2> choose_uv_sets(MetallicRoughness& surface, const std::string& where, Report& report);

}  // namespace lippmann::gltf
