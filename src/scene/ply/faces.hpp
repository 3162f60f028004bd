// Reads the elements of a PLY file that make triangles: faces and strips.
#pragma once

#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/split_faces.hpp"

namespace lippmann::ply {

/// A mesh as the file has it: attributes of vertices, and of triangles where faces have some.
struct PlyMesh {
  Mesh mesh;
  std::vector<FaceLook> looks;      ///< by triangle; empty: faces have no attributes
  std::vector<int> vertex_picture;  ///< by vertex; empty: not given
  FaceAttributes own;
  Vec3d origin{0.0};  ///< subtracted from positions
};

/// Both append to ply.mesh.triangles. They throw Error, and warn, by name, of properties that are not read. `name` is what
/// errors call the file.
void read_faces(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply);
void read_strips(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply);

}  // namespace lippmann::ply
