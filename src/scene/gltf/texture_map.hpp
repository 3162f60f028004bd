// Turns the texture references of glTF materials into TextureMaps.
#pragma once

#include <array>
#include <functional>

#include "scene/gltf/texture.hpp"

namespace lippmann::gltf {

/// What a textureInfo of the file says.
struct MapSource {
  int texture = -1;  ///< -1: there is none
  int uv_set = 0;
  const tinygltf::Value* transform = nullptr;  ///< KHR_texture_transform
};

/// The source that a textureInfo of the core names: TextureInfo, NormalTextureInfo or OcclusionTextureInfo.
template <class Info>
MapSource map_source(const Info& info) {
  const auto found = info.extensions.find("KHR_texture_transform");
  return {info.index, info.texCoord, found == info.extensions.end() ? nullptr : &found->second};
}

/// The source that a textureInfo within an extension names; null: there is no textureInfo.
MapSource map_source(const tinygltf::Value* info);

/// Decodes the texture. The map's uv_set is still the file's n of TEXCOORD_n. srgb: its colours are encoded; false for data.
TextureMap read_map(const MapSource& source, bool srgb, TextureReader& textures);

/// The same where read(texture of the file) makes the Scene's.
TextureMap read_map_from(const MapSource& source, const std::function<int(int)>& read);

/// Which TEXCOORD_n become Mesh::uvs and uvs_1 (-1: none) for this surface; renumbers its maps' uv_set accordingly. Beyond two
/// sets: a warning, and the first one is used.
std::array<int, 2> choose_uv_sets(MetallicRoughness& surface, const std::string& where, Report& report);

}  // namespace lippmann::gltf
