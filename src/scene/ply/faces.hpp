// Reads the faces and triangle strips of a PLY file.
#pragma once

#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/split_faces.hpp"

namespace lippmann::ply {

/// A mesh as stored in the file: attributes per vertex, and per triangle if faces have attributes.
struct PlyMesh {
  Mesh mesh;
  std::vector<FaceAppearance> appearances;  ///< by triangle; empty: faces have no attributes
  std::vector<int> vertex_picture;          ///< texture number by vertex; empty: none
  FaceAttributes own;
  Vec3d origin{0.0};  ///< the point that was subtracted from positions
};

/// Append the triangles of faces, or of strips, to ply.mesh.triangles. Warn about unread properties by name. `name` names the
/// file in messages. Throw Error.
void read_faces(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply);
void read_strips(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply);

}  // namespace lippmann::ply
