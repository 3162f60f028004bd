// Reads PLY files that hold points and no faces, as scanners and COLMAP write them.
#pragma once

#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Whether a file's header describes points: vertices with a position, and neither faces nor strips.
bool has_points(const Header& header);

/// Whether these points are shown as splats in their own colours; points without colours are shown as spheres, lit.
bool has_point_colors(const Header& header);

/// Returns one instance of all points. `size`: their diameter in the file's units; 0: 1.2 times the median distance to the
/// third neighbour. `origin` (Scene::origin) is subtracted. Throws Error. Points that are not finite, and properties and
/// elements that are not read, are left out with a warning.
Scene read_points(const std::string& name, const Header& header, Body& body, double size, const Vec3d& origin,
                  const Context& context);

}  // namespace lippmann::ply
