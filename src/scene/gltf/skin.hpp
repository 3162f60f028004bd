// Reads what deforms glTF meshes: skins, the vertices' weights for them, morph targets and their weights.
#pragma once

#include <map>

#include "scene/gltf/attribute.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Reads each skin once, when a node first uses it.
class SkinReader {
 public:
  SkinReader(Document& document, const NodeMap& nodes, Scene& scene) : document_(document), nodes_(nodes), scene_(scene) {}

  /// The index in scene.skins of a skin of the file. -1: it has no joints. Throws Error.
  int read(int skin);

 private:
  Document& document_;
  const NodeMap& nodes_;
  Scene& scene_;
  std::map<int, int> known_;
};

/// All sets JOINTS_0 and WEIGHTS_0, JOINTS_1 ...; weights are made to sum to 1. Vertices without any hang on the first joint.
/// joints: how many the skin has.
void read_skin_weights(Document& document, PrimitiveId id, std::size_t joints, Mesh& mesh);

/// The primitive's morph targets; of what the mesh lacks (normals, tangents) nothing is read.
void read_targets(Document& document, PrimitiveId id, Mesh& mesh);

/// The node's weights, or its mesh's, or zeros: as many as the mesh has targets. Throws Error where their number differs.
std::vector<float> read_morph_weights(Document& document, int file_node);

}  // namespace lippmann::gltf
