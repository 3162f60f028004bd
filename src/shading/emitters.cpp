#include "shading/emitters.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

/// A triangle is divided into at most kMostParts parts along each edge, with one texture lookup per part.
constexpr int kMostParts = 2;
/// Lower bounds, because texture lookups may miss small bright areas. kLeastShare bounds the luminance of a textured triangle,
/// relative to the mean luminance of the texture. kLeastMean bounds each channel of the mean colour of the texture.
constexpr float kLeastShare = 1e-2f, kLeastMean = 1.0f / 65535.0f;
constexpr std::size_t kPiece = 4096;

struct MapParts {
  std::size_t level;
  int per_edge;
};

/// Returns the mip level of the lookups and the number of parts per edge. `extent` is the larger of the triangle's width and
/// height, in texels of the finest level.
MapParts parts_of(const DeviceTexture& texture, float extent) {
  const std::size_t last = texture.levels.size() - 1;
  if (!(extent < 1e9f)) return {last, 1};
  std::size_t level = 0;
  while (level < last && extent > kMostParts) extent *= 0.5f, ++level;
  return {level, std::clamp(static_cast<int>(std::ceil(extent)), 1, level < last ? kMostParts : 1)};
}

/// Divides a triangle into per_edge^2 equal triangles. Calls visit(barycentric) for their centres.
template <class Visit>
void visit_parts(int per_edge, const Visit& visit) {
  const auto at = [&](int i, int j, float third) {
    visit(Vec2f(static_cast<float>(i) + third, static_cast<float>(j) + third) / static_cast<float>(per_edge));
  };
  for (int i = 0; i < per_edge; ++i)
    for (int j = 0; i + j < per_edge; ++j) {
      at(i, j, 1.0f / 3.0f);
      if (i + j + 1 < per_edge) at(i, j, 2.0f / 3.0f);
    }
}

float least_luminance(const WhittedMaterial& material, const DeviceTexture& texture) {
  const std::vector<std::uint16_t>& mean = texture.levels.back().rgba;
  const Vec3f rgb = Vec3f(mean[0], mean[1], mean[2]) / 65535.0f;
  return kLeastShare * luminance(material.emission * glm::max(rgb, Vec3f(kLeastMean)));
}

void look_up_triangles(const Mesh& mesh, const WhittedMaterial& material, const DeviceTexture& texture, const ThreadPool& pool,
                       std::vector<float>& by_triangle) {
  by_triangle.resize(mesh.triangles.size());
  const float least = least_luminance(material, texture);
  pool.for_each((by_triangle.size() + kPiece - 1) / kPiece, [&](std::size_t piece) {
    const std::size_t end = std::min((piece + 1) * kPiece, by_triangle.size());
    for (std::size_t t = piece * kPiece; t < end; ++t) {
      const Vec3f mean = mean_over_triangle(material.emission_map, texture, mesh, t);
      by_triangle[t] = std::max(luminance(material.emission * mean), least);
    }
  });
}

using ShapeAndMaterial = std::pair<int, int>;

bool emits(const WhittedMaterial& material) { return material.emission != Vec3f(0.0f); }

}  // namespace

Vec3f mean_over_triangle(const TextureMap& map, const DeviceTexture& texture, const Mesh& mesh, std::size_t triangle) {
  const std::vector<Vec2f>& uvs = uvs_of(mesh, map.uv_set);
  if (uvs.empty()) return Vec3f(1.0f);
  const auto& [ia, ib, ic] = mesh.triangles[triangle];
  const Vec2f a = map.offset + map.matrix * uvs[ia], b = map.matrix * (uvs[ib] - uvs[ia]), c = map.matrix * (uvs[ic] - uvs[ia]);
  const Vec2f texels(texture.levels.front().width, texture.levels.front().height);
  const Vec2f extent = glm::max(glm::max(glm::abs(b), glm::abs(c)), glm::abs(c - b)) * texels;
  const MapParts parts = parts_of(texture, extent.x + extent.y < kInfinity ? std::max(extent.x, extent.y) : kInfinity);
  Vec3f sum(0.0f);
  visit_parts(parts.per_edge, [&](Vec2f at) { sum += Vec3f(sample_point(texture, a + at.x * b + at.y * c, parts.level)); });
  return sum / static_cast<float>(parts.per_edge * parts.per_edge);
}

Emitters::Emitters(const Scene& scene, std::span<const WhittedMaterial> materials, std::span<const DeviceTexture> textures,
                   const ThreadPool& pool)
    : of_instance_(scene.instances.size(), -1) {
  std::map<ShapeAndMaterial, int> known;
  std::vector<ShapeAndMaterial> keys;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const bool is_mesh = std::holds_alternative<Mesh>(scene.shapes[static_cast<std::size_t>(instance.shape)]);
    if (!is_mesh || !emits(materials[static_cast<std::size_t>(instance.material)])) continue;
    const ShapeAndMaterial key{instance.shape, instance.material};
    const auto [entry, is_new] = known.try_emplace(key, static_cast<int>(keys.size()));
    if (is_new) keys.push_back(key);
    of_instance_[i] = entry->second;
  }
  emitters_.resize(keys.size());
  const auto mesh_of = [&](std::size_t e) -> const Mesh& {
    return std::get<Mesh>(scene.shapes[static_cast<std::size_t>(keys[e].first)]);
  };
  pool.for_each(keys.size(), [&](std::size_t e) { emitters_[e].closed = facing_of_closed(mesh_of(e)); });
  for (std::size_t e = 0; e < keys.size(); ++e) {
    const WhittedMaterial& material = materials[static_cast<std::size_t>(keys[e].second)];
    emitters_[e].luminance = luminance(material.emission);
    const int map = material.emission_map.texture;
    if (map >= 0)
      look_up_triangles(mesh_of(e), material, textures[static_cast<std::size_t>(map)], pool, emitters_[e].by_triangle);
  }
}

}  // namespace lippmann
