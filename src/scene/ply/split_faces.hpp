// Gives the corners of faces colours and texture coordinates of their own, which PLY files have per face and our meshes per
// vertex.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::ply {

/// Attributes of a face, for one of its triangles.
struct FaceLook {
  std::array<Vec2f, 3> uvs{};  ///< of the triangle's corners
  Vec3f color{1.0f};           ///< linear
  float alpha = 1.0f;
  int picture = -1;  ///< which of the file's pictures; -1: none
};

/// Which attributes come from FaceLook; the others stay those of the vertices.
struct FaceAttributes {
  bool uvs = false, colors = false, alphas = false;
};

/// The mesh in one part per picture. looks[i] belongs to triangle i. Corners that agree in everything share a vertex.
std::map<int, Mesh> split_faces(const Mesh& mesh, const std::vector<FaceLook>& looks, const FaceAttributes& own);

}  // namespace lippmann::ply
