// Reads the deformations of glTF meshes: skins, vertex weights, morph targets and their weights.
#pragma once

#include <map>

#include "scene/gltf/attribute.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Reads each skin once, when a node first uses it.
class SkinReader {
 public:
  SkinReader(Document& document, const NodeMap& nodes, Scene& scene) : document_(document), nodes_(nodes), scene_(scene) {}

  /// Returns the index in scene.skins of a skin of the file; -1 if it has no joints. Throws Error.
  int read(int skin);

 private:
  Document& document_;
  const NodeMap& nodes_;
  Scene& scene_;
  std::map<int, int> known_;
};

/// Reads the joints and weights of all sets (JOINTS_0, WEIGHTS_0, JOINTS_1, ...). Weights are normalised to a sum of 1;
/// vertices without weights follow the first joint. `joints`: number of joints of the skin.
void read_skin_weights(Document& document, PrimitiveId id, std::size_t joints, Mesh& mesh);

/// Reads the primitive's morph targets. Skips normals and tangents if the mesh has none.
void read_targets(Document& document, PrimitiveId id, Mesh& mesh);

/// Returns one weight per morph target of the node's mesh: those of the node, otherwise those of the mesh, otherwise zeros.
/// Throws Error if their number differs from that of the targets.
std::vector<float> read_morph_weights(Document& document, int file_node);

}  // namespace lippmann::gltf
