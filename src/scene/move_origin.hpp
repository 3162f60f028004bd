#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct Affine3d {
  glm::dmat3 linear{1.0};
  Vec3d translation{0.0};
};

/// Moves the origin of a scene to a given point in its present coordinates. See move_near_origin(). `parent_from_node` may give
/// the transforms of the scene's first nodes in double precision; it is ignored for nodes with an animated translation.
void move_origin(Scene& scene, Vec3d origin, const std::vector<Affine3d>& parent_from_node = {});

}  // namespace lippmann
