// Adds up what a glTF file unpacks to, from the counts that it states.
#pragma once

#include <string>

#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Throws Error at the first element beyond GltfLimits::unpacked_bytes, before anything is unpacked: packed buffer views, Draco
/// primitives, meshes, splats and instances that are shown, the keys of an animation. The sum leaves out some small parts,
/// which Document::unpacked counts while they are read. animation: as read_animation() has it.
void refuse_excess(const Document& document, const NodeMap& nodes, const std::string& animation);

}  // namespace lippmann::gltf
