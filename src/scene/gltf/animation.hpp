// Turns a glTF file's first animation into a Timeline.
#pragma once

#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"
#include "scene/scene.hpp"

namespace lippmann::gltf {

/// Fills scene.timeline. Throws Error where times do not increase or values do not match them.
void read_animation(Document& document, const NodeMap& nodes, double frames_per_second, Scene& scene);

}  // namespace lippmann::gltf
