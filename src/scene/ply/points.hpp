#pragma once

#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

bool has_points(const Header& header);

/// Returns whether the points have colours. Coloured points become unlit splats; points without colours become lit spheres.
bool has_point_colors(const Header& header);

/// Returns a scene with one instance that contains all points. `size` is the diameter of the points in the file's units. If it
/// is 0, the diameter is the median distance to the third nearest neighbour, multiplied by 2 for spheres or by 1.6 for splats.
///
/// Subtracts `origin` (Scene::origin). Leaves out points that are not finite, and unused properties and elements, and warns
/// about them. Throws Error.
Scene read_points(const std::string& name, const Header& header, Body& body, double size, const Vec3d& origin,
                  const Context& context);

}  // namespace lippmann::ply
