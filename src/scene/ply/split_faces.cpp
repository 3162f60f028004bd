#include "scene/ply/split_faces.hpp"

#include <bit>
#include <unordered_map>

namespace lippmann::ply {
namespace {

struct SplitCorner {
  std::uint32_t vertex;
  Vec2f uv;
  Vec3f color;
  float alpha;
  bool operator==(const SplitCorner&) const = default;
};

struct SplitCornerHash {
  std::size_t operator()(const SplitCorner& c) const {
    std::uint64_t hash = c.vertex;
    for (const float value : {c.uv.x, c.uv.y, c.color.x, c.color.y, c.color.z, c.alpha})
      hash = (hash ^ std::bit_cast<std::uint32_t>(value + 0.0f)) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 32;
  }
};

struct SplitPart {
  Mesh mesh;
  std::unordered_map<SplitCorner, std::uint32_t, SplitCornerHash> placed;
};

std::uint32_t place(SplitPart& part, const SplitCorner& corner, const Mesh& from, const FaceAttributes& own) {
  const auto [known, is_new] = part.placed.try_emplace(corner, static_cast<std::uint32_t>(part.mesh.positions.size()));
  if (!is_new) return known->second;
  Mesh& to = part.mesh;
  to.positions.push_back(from.positions[corner.vertex]);
  if (!from.normals.empty()) to.normals.push_back(from.normals[corner.vertex]);
  if (own.uvs) to.uvs.push_back(corner.uv);
  if (!own.uvs && !from.uvs.empty()) to.uvs.push_back(from.uvs[corner.vertex]);
  if (own.colors) to.colors.push_back(corner.color);
  if (!own.colors && !from.colors.empty()) to.colors.push_back(from.colors[corner.vertex]);
  if (own.alphas) to.alphas.push_back(corner.alpha);
  if (!own.alphas && !from.alphas.empty()) to.alphas.push_back(from.alphas[corner.vertex]);
  return known->second;
}

}  // namespace

std::map<int, Mesh> split_faces(const Mesh& mesh, const std::vector<FaceAppearance>& appearances, const FaceAttributes& own) {
  std::map<int, SplitPart> parts;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    SplitPart& part = parts[appearances[i].picture];
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      SplitCorner corner{mesh.triangles[i][k], Vec2f(0.0f), Vec3f(1.0f), 1.0f};
      if (own.uvs) corner.uv = appearances[i].uvs[k];
      if (own.colors) corner.color = appearances[i].color;
      if (own.alphas) corner.alpha = appearances[i].alpha;
      triangle[k] = place(part, corner, mesh, own);
    }
    part.mesh.triangles.push_back(triangle);
  }
  std::map<int, Mesh> meshes;
  for (auto& [picture, part] : parts) meshes.emplace(picture, std::move(part.mesh));
  return meshes;
}

}  // namespace lippmann::ply
