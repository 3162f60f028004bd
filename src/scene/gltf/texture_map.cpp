// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 5.29 "Texture Info", and KHR_texture_transform, which
// defines uv' = T R S uv, where R rotates by the angle a: u' = u cos a + v sin a, v' = -u sin a + v cos a. The extension's
// texCoord overrides that of the textureInfo.
#include "scene/gltf/texture_map.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace lippmann::gltf {
namespace {

void set_transform(Value transform, TextureMap& map) {
  const Vec2f scale = transform["scale"].vector(Vec2f(1.0f));
  const double angle = transform["rotation"].number(0.0);
  const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  map.matrix = {scale.x * Vec2f(c, -s), scale.y * Vec2f(s, c)};
  map.offset = transform["offset"].vector(Vec2f(0.0f));
  map.uv_set = transform["texCoord"].integer(map.uv_set);
}

/// Returns the maps of a surface. choose_uv_sets() prefers the uv sets of maps that come first in this list.
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

TextureMap read_map(Value info, bool srgb, TextureReader& textures) {
  return read_map_from(info, [&](int texture) { return textures.read(texture, srgb); });
}

TextureMap read_map_from(Value info, const std::function<int(int)>& read) {
  TextureMap map;
  if (!info) return map;
  map.texture = read(info["index"].index());
  map.uv_set = info["texCoord"].integer(0);
  if (const Value transform = info.extension("KHR_texture_transform")) set_transform(transform, map);
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
