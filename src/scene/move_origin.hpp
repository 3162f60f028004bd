// Moves a scene to another origin, in double precision.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// The map p -> linear * p + translation.
struct Affine3d {
  glm::dmat3 linear{1.0};
  Vec3d translation{0.0};
};

/// Moves the scene to a given origin (in its present coordinates), as move_near_origin() does. parent_from_node: more exact
/// transforms of the scene's first nodes, where known; ignored for animated translations.
void move_origin(Scene& scene, Vec3d origin, const std::vector<Affine3d>& parent_from_node = {});

}  // namespace lippmann
