#pragma once

#include <string>
#include <string_view>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

bool has_splats(const Header& header);

/// Returns a scene with one instance that contains the file's splats, turned so that y points up.
///
/// Subtracts `origin` (Scene::origin). Leaves out invalid splats (no size, no rotation, values that are not finite) and unused
/// properties and elements, and warns about them. Throws Error.
Scene read_splats(const std::string& name, const Header& header, Body& body, const Vec3d& origin, const Context& context);

}  // namespace lippmann::ply
