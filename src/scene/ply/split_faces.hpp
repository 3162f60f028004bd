#pragma once

#include <array>
#include <map>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::ply {

struct FaceAppearance {
  std::array<Vec2f, 3> uvs{};
  Vec3f color{1.0f};
  float alpha = 1.0f;
  int picture = -1;
};

/// The attributes that are taken from FaceAppearance. All others are taken from the vertices.
struct FaceAttributes {
  bool uvs = false, colors = false, alphas = false;
};

/// Splits a mesh into one mesh per texture number. appearances[i] belongs to triangle i. Corners with equal attributes share a
/// vertex.
std::map<int, Mesh> split_faces(const Mesh& mesh, const std::vector<FaceAppearance>& appearances, const FaceAttributes& own);

}  // namespace lippmann::ply
