#pragma once

#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/split_faces.hpp"

namespace lippmann::ply {

/// A mesh as stored in the file. Attributes belong to vertices or, if the faces have attributes, to triangles.
struct PlyMesh {
  Mesh mesh;
  std::vector<FaceAppearance> appearances;
  std::vector<int> vertex_picture;
  FaceAttributes own;
  Vec3d origin{0.0};
};

/// These functions append the triangles of an element (faces or strips) to ply.mesh.triangles, and warn about unused
/// properties. They throw Error for invalid data.
void read_faces(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply);
void read_strips(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply);

}  // namespace lippmann::ply
