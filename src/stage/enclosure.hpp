// Tests whether a scene's surfaces block all light from outside.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// Returns whether `point` (in world space) is surrounded by dark surfaces, such as a closed room or a dome. Emissive surfaces
/// count as light. Transparent and cut-out surfaces do not block light. Traces 64 rays against the meshes only; skinned meshes
/// have their rest pose. Small gaps between these rays are missed. In a closed room, each ray tests every triangle. Elsewhere
/// the first ray that reaches light ends the test, so few rays are needed.
bool is_enclosed(const Scene& scene, const ResolvedScene& resolved, Vec3f point);

}  // namespace lippmann
