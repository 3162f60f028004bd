// Estimates the memory that a glTF file needs when unpacked, from the counts it states.
#pragma once

#include <string>

#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Throws Error at the first element that exceeds GltfLimits::unpacked_bytes, before anything is unpacked. The sum covers
/// packed buffer views, Draco primitives, visible meshes, splats and instances, and animation keys. Document::unpacked counts
/// the remaining small parts during reading. `animation`: as in read_animation().
void check_demand(const Document& document, const NodeMap& nodes, const std::string& animation);

}  // namespace lippmann::gltf
