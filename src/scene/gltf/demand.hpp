#pragma once

#include <string>

#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Estimates how much memory a file needs, from the counts that it states, before anything is unpacked. Throws Error at the
/// first element with which the sum exceeds GltfLimits::unpacked_bytes. `animation` selects the animation as in
/// read_animation().
void check_demand(const Document& document, const NodeMap& nodes, const std::string& animation);

}  // namespace lippmann::gltf
