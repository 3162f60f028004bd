// Reads a glTF animation into a Timeline.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Fills scene.timeline and scene.animation_names. `wanted`: name or index of the animation; empty: the first.
/// frames_per_second: the frame rate, or 0 to choose one at which the keys fall on frames. Throws Error if there is no such
/// animation, times do not increase, or the number of values does not match the times.
void read_animation(Document& document, const NodeMap& nodes, const std::string& wanted, double frames_per_second,
                    Scene& scene);

}  // namespace lippmann::gltf
