// Reads the faces and triangle strips of a PLY file.
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
  std::vector<FaceAppearance> appearances;  ///< one element per triangle; empty: faces have no attributes
  std::vector<int> vertex_picture;          ///< texture number of each vertex; empty: none
  FaceAttributes own;
  Vec3d origin{0.0};  ///< point that was subtracted from all positions
};

/// These functions append the triangles of an element (faces or strips) to ply.mesh.triangles, and warn about unused
/// properties. `name` is the file's name in messages. They throw Error for invalid data.
void read_faces(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply);
void read_strips(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply);

}  // namespace lippmann::ply
