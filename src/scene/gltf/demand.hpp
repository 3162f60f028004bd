// Estimates how much memory a glTF file will need, before anything is unpacked. The estimate uses the counts that the file
// states.
#pragma once

#include <string>

#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Throws Error at the first element with which the sum exceeds GltfLimits::unpacked_bytes. The sum covers compressed buffer
/// views, Draco primitives, visible meshes, splats, instances and animation keys. The remaining parts are small; they are
/// counted in Document::unpacked while they are read. `animation` selects the animation as in read_animation().
void check_demand(const Document& document, const NodeMap& nodes, const std::string& animation);

}  // namespace lippmann::gltf
