// Reads splats (3D Gaussians) from PLY files in the layout of the reference implementation.
#pragma once

#include <string>
#include <string_view>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Returns whether a header describes splats: vertices with a scale, and a rotation or an opacity.
bool has_splats(const Header& header);

/// Returns a scene with one instance of the file's splats. The file's y points down unless its header states that z points up;
/// the scene's y points up. Subtracts `origin` (Scene::origin). Leaves out invalid splats (no size, no rotation, values that
/// are not finite) and unread properties and elements, with warnings. Throws Error.
Scene read_splats(const std::string& name, const Header& header, Body& body, const Vec3d& origin, const Context& context);

}  // namespace lippmann::ply
