#pragma once

#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"
#include "scene/side_textures.hpp"

namespace lippmann::ply {

/// Adds one instance per texture to the scene. Subtracts scene.origin from all positions. Warns about unused properties,
/// elements and textures. `textures` must add to the same scene. Throws Error.
void read_mesh(const std::string& name, const Header& header, Body& body, SideTextures& textures, const Context& context,
               Scene& scene);

}  // namespace lippmann::ply
