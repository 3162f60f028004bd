// Deforms a skinned mesh into its rest pose.
#pragma once

#include "scene/gltf/mesh.hpp"
#include "scene/gltf/nodes.hpp"
#include "scene/timeline.hpp"

namespace lippmann::gltf {

/// Moves the mesh's vertices, from its own coordinates, to where the skin's joints hold them in world space. `rest` has the
/// Scene's nodes where they stand without animation. Throws Error.
void pose_at_rest(Document& document, PrimitiveId id, int skin, const NodeMap& nodes, const ResolvedScene& rest, Mesh& mesh);

}  // namespace lippmann::gltf
