// Reads the mesh of a PLY file: vertices, faces and strips, with the pictures that its comments name.
#pragma once

#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"
#include "scene/side_textures.hpp"

namespace lippmann::ply {

/// One instance for each picture. Throws Error; properties, elements and pictures that are not used are warnings. `name` is
/// what errors call the file. `textures` belong to `scene`, whose origin is subtracted from positions.
void read_mesh(const std::string& name, const Header& header, Body& body, SideTextures& textures, const Context& context,
               Scene& scene);

}  // namespace lippmann::ply
