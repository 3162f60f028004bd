// Gives a scene another origin, in double precision.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// p -> linear * p + translation.
struct Affine3d {
  glm::dmat3 linear{1.0};
  Vec3d translation{0.0};
};

/// What move_near_origin() does for a given origin (in the scene's present coordinates). parent_from_node: the transforms of
/// the scene's first nodes more exactly than its floats have them, where they are known; not looked at for animated
/// translations.
void move_origin(Scene& scene, Vec3d origin, const std::vector<Affine3d>& parent_from_node = {});

}  // namespace lippmann
