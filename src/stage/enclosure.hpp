// Tests whether a scene's surfaces block all light from outside.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// Returns whether dark surfaces surround `point` (world space), as in a closed room or a dome. Emissive, transparent and
/// cut-out surfaces do not count. Traces 64 rays against the meshes, so small gaps are missed. In a closed room, each ray tests
/// every triangle.
bool is_enclosed(const Scene& scene, const ResolvedScene& resolved, Vec3f point);

}  // namespace lippmann
