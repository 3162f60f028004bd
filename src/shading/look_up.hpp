#pragma once

#include <array>
#include <span>

#include "lippmann/scene/scene.hpp"
#include "shading/texture.hpp"

namespace lippmann {

/// Interpolates a per-vertex quantity. `barycentric` holds the weights of the triangle's second and third corner.
template <class Value>
Value interpolate(const std::vector<Value>& of_vertex, const std::array<std::uint32_t, 3>& corners, Vec2f barycentric) {
  return (1.0f - barycentric.x - barycentric.y) * of_vertex[corners[0]] + barycentric.x * of_vertex[corners[1]] +
         barycentric.y * of_vertex[corners[2]];
}

/// Returns the linear RGBA of a map at a point, or white if the map has no texture or the mesh has no coordinates for it.
inline Vec4f look_up(const TextureMap& map, std::span<const DeviceTexture> textures, const Mesh& mesh, std::uint32_t triangle,
                     Vec2f barycentric) {
  const std::vector<Vec2f>& uvs = uvs_of(mesh, map.uv_set);
  if (map.texture < 0 || uvs.empty()) return Vec4f(1.0f);
  const Vec2f uv = map.offset + map.matrix * interpolate(uvs, mesh.triangles[triangle], barycentric);
  return sample_point(textures[static_cast<std::size_t>(map.texture)], uv);
}

}  // namespace lippmann
