// Converts the colours and texture coordinates of PLY faces to attributes of vertices.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::ply {

/// The face attributes of one triangle.
struct FaceAppearance {
  std::array<Vec2f, 3> uvs{};  ///< texture coordinates of the three corners
  Vec3f color{1.0f};           ///< linear colour
  float alpha = 1.0f;
  int picture = -1;  ///< texture number in the file; -1: none
};

/// Marks the attributes that are taken from FaceAppearance. All other attributes are taken from the vertices.
struct FaceAttributes {
  bool uvs = false, colors = false, alphas = false;
};

/// Splits a mesh into one mesh per texture number. appearances[i] belongs to triangle i. Corners with equal attributes share a
/// vertex.
std::map<int, Mesh> split_faces(const Mesh& mesh, const std::vector<FaceAppearance>& appearances, const FaceAttributes& own);

}  // namespace lippmann::ply
