// Reads PLY point clouds, such as those from scanners and COLMAP.
#pragma once

#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Returns whether a header describes a point cloud: vertices with positions, without faces or strips.
bool has_points(const Header& header);

/// Returns whether the points have colours. Such points are shown as unlit splats; points without colours as lit spheres.
bool has_point_colors(const Header& header);

/// Returns a scene with one instance that holds all points. `size`: the diameter of the points in the file's units; 0: 2 times
/// (spheres) or 1.6 times (splats) the median distance to the third neighbour. Subtracts `origin` (Scene::origin). Leaves out
/// points that are not finite, and properties and elements that it does not read, with warnings. Throws Error.
Scene read_points(const std::string& name, const Header& header, Body& body, double size, const Vec3d& origin,
                  const Context& context);

}  // namespace lippmann::ply
