// Whether a scene's surfaces keep out all light from outside.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// Whether who stands at `point` (world) has dark surfaces on all sides: a closed room, or a dome. Surfaces that shine give
/// light themselves, and what is clear or cut out by its alpha keeps none out. Looks along 64 directions, at the meshes alone,
/// those with skins at rest; gaps that all directions miss count for nothing. Time: that of 64 looks at every triangle in a
/// closed room, of a few elsewhere.
bool is_enclosed(const Scene& scene, const ResolvedScene& resolved, Vec3f point);

}  // namespace lippmann
