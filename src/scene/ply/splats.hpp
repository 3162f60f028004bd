// Reads splats (3D Gaussians) from PLY files of the layout that their training writes.
#pragma once

#include <string>
#include <string_view>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Whether a file's header describes splats: vertices that have a scale, and a rotation or an opacity.
bool has_splats(const Header& header);

/// The splats of the file, one instance of them, y downwards in the file and upwards in the scene; or z upwards, where the
/// file says so. Throws Error. Splats that cannot be shown (no size, no rotation, values that are not finite), and properties
/// and elements that are not read, are left out with a warning.
Scene read_splats(const std::string& name, const Header& header, Body& body, const Context& context);

}  // namespace lippmann::ply
