// Turns one of a glTF file's animations into a Timeline.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Fills scene.timeline and scene.animation_names. wanted: the animation's name or index; empty: the first. Throws Error where
/// there is no such animation, times do not increase or values do not match them. frames_per_second: 0: that of the keys.
void read_animation(Document& document, const NodeMap& nodes, const std::string& wanted, double frames_per_second,
                    Scene& scene);

}  // namespace lippmann::gltf
