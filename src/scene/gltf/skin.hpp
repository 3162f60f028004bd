#pragma once

#include <map>

#include "scene/gltf/attribute.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Reads each skin when a node first uses it.
class SkinReader {
 public:
  SkinReader(Document& document, const NodeMap& nodes, Scene& scene) : document_(document), nodes_(nodes), scene_(scene) {}

  /// Returns the index in scene.skins of a skin of the file, or -1 if the skin has no joints. Throws Error.
  int read(int skin);

 private:
  Document& document_;
  const NodeMap& nodes_;
  Scene& scene_;
  std::map<int, int> known_;
};

/// Reads the joints and weights of all sets (JOINTS_0, WEIGHTS_0, JOINTS_1, ...) into mesh.skin. The weights of a vertex are
/// divided by their sum. Vertices without weights follow the first joint. `joints` is the number of joints of the skin. Throws
/// Error.
void read_skin_weights(Document& document, PrimitiveId id, std::size_t joints, Mesh& mesh);

/// Reads the morph targets of a primitive into mesh.targets. Skips normals and tangents of targets if the mesh itself has none.
void read_targets(Document& document, PrimitiveId id, Mesh& mesh);

/// Returns one weight per morph target of the node's mesh: those of the node if it has any, otherwise those of the mesh,
/// otherwise zeros. Throws Error if the number of weights differs from the number of targets.
std::vector<float> read_morph_weights(Document& document, int file_node);

}  // namespace lippmann::gltf
