// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 5.29 "Texture Info"; KHR_texture_transform: uv' = T R S uv,
// with R turning by the angle a as u' = cos a u + sin a v, v' = -sin a u + cos a v; its texCoord replaces the textureInfo's.
#include "scene/gltf/texture_map.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace lippmann::gltf {
namespace {

Vec2f pair(const tinygltf::Value& object, const char* name, Vec2f otherwise) {
  if (!object.Has(name)) return otherwise;
  const tinygltf::Value& value = object.Get(name);
  return {static_cast<float>(value.Get(0).GetNumberAsDouble()), static_cast<float>(value.Get(1).GetNumberAsDouble())};
}

void set_transform(const tinygltf::Value& transform, TextureMap& map) {
  const Vec2f scale = pair(transform, "scale", Vec2f(1.0f));
  const double angle = transform.Has("rotation") ? transform.Get("rotation").GetNumberAsDouble() : 0.0;
  const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  map.matrix = {scale.x * Vec2f(c, -s), scale.y * Vec2f(s, c)};
  map.offset = pair(transform, "offset", Vec2f(0.0f));
  if (transform.Has("texCoord")) map.uv_set = transform.Get("texCoord").GetNumberAsInt();
}

/// In the order in which they choose their sets.
std::vector<TextureMap*> maps_of(MetallicRoughness& s) {
  std::vector<TextureMap*> maps{&s.base_color_map, &s.normal_map,           &s.metallic_roughness_map, &s.emissive_map,
                                &s.occlusion_map,  &s.transmission_map,     &s.specular_map,           &s.specular_color_map,
                                &s.clearcoat_map,  &s.clearcoat_normal_map, &s.clearcoat_roughness_map};
  if (!s.extensions) return maps;
  SurfaceExtensions& e = *s.extensions;
  maps.insert(maps.end(), {&e.sheen.color_map, &e.sheen.roughness_map, &e.anisotropy.map, &e.iridescence.map,
                           &e.iridescence.thickness_map, &e.diffuse_transmission.map, &e.diffuse_transmission.color_map});
  return maps;
}

}  // namespace

MapSource map_source(const tinygltf::Value* info) {
  if (!info) return {};
  MapSource source{info->Get("index").GetNumberAsInt(), 0, nullptr};
  if (info->Has("texCoord")) source.uv_set = info->Get("texCoord").GetNumberAsInt();
  if (info->Has("extensions") && info->Get("extensions").Has("KHR_texture_transform"))
    source.transform = &info->Get("extensions").Get("KHR_texture_transform");
  return source;
}

TextureMap read_map(const MapSource& source, bool srgb, TextureReader& textures) {
  return read_map_from(source, [&](int texture) { return textures.read(texture, srgb); });
}

TextureMap read_map_from(const MapSource& source, const std::function<int(int)>& read) {
  TextureMap map;
  if (source.texture < 0) return map;
  map.texture = read(source.texture);
  map.uv_set = source.uv_set;
  if (source.transform) set_transform(*source.transform, map);
  return map;
}

std::array<int, 2> choose_uv_sets(MetallicRoughness& surface, const std::string& where, Report& report) {
  std::array<int, 2> chosen{-1, -1};
  for (TextureMap* map : maps_of(surface)) {
    const int wanted = std::exchange(map->uv_set, 0);
    if (map->texture < 0) continue;
    if (chosen[0] < 0) chosen[0] = wanted;
    if (chosen[0] == wanted) continue;
    if (chosen[1] < 0) chosen[1] = wanted;
    if (chosen[1] == wanted)
      map->uv_set = 1;
    else
      report.not_supported("more than two sets of texture coordinates in one material are",
                           "the base colour's set is used in place of the third", where);
  }
  if (chosen[0] < 0) chosen[0] = 0;
  return chosen;
}

}  // namespace lippmann::gltf
