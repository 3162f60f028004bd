// Tests whether a scene's surfaces block all light from outside.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// Returns whether `point` (world) is surrounded by dark surfaces: a closed room, or a dome. Emissive surfaces count as light,
/// and transparent or cut-out surfaces do not block it. Traces 64 rays against the meshes only, with skinned meshes in their
/// rest pose; smaller gaps are missed. In a closed room, each ray tests every triangle; elsewhere only a few rays are needed.
bool is_enclosed(const Scene& scene, const ResolvedScene& resolved, Vec3f point);

}  // namespace lippmann
