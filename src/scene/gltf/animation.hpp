#pragma once

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/nodes.hpp"

namespace lippmann::gltf {

/// Sets scene.timeline and scene.animation_names. `wanted` is the name or index of the animation to read; empty: the first one.
/// If frames_per_second is 0, the reader chooses a rate at which the keys fall on frames. Throws Error if the animation does
/// not exist, if its times do not increase, or if the numbers of values and times do not match.
void read_animation(Document& document, const NodeMap& nodes, const std::string& wanted, double frames_per_second,
                    Scene& scene);

}  // namespace lippmann::gltf
