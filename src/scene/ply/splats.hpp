// Reads splats (3D Gaussians) from PLY files of the layout that their training writes.
#pragma once

#include <string>
#include <string_view>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Whether a file's header describes splats: vertices that have a scale, a rotation, an opacity and a colour as splats have.
bool has_splats(const Header& header);

/// The splats of the file, one instance of them, y downwards in the file and upwards in the scene. `body` follows the header.
/// Throws Error. Splats that are none (no size, no rotation, values that are not finite) are left out, with a warning.
Scene read_splats(const std::string& name, const Header& header, std::string_view body, const Context& context);

}  // namespace lippmann::ply
