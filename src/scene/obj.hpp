// Reads Wavefront OBJ files (.obj) and their materials (.mtl) as a Scene without cameras; docs/guide/scenes.md describes the
// interpretation.
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann {

/// Loads a file. Materials and textures may lie in the file's folder or below asset_root, if given. Warns about files that are
/// missing or lie elsewhere, and about textures that are reduced to fit into `texture_bytes` (see LoadOptions). `origin` is
/// Scene::origin. Throws Error naming file and line.
Scene load_obj(const std::filesystem::path& path, const Context& context, const std::filesystem::path& asset_root = {},
               std::uint64_t texture_bytes = LoadOptions{}.texture_bytes, const Vec3d& origin = Vec3d(0.0));

}  // namespace lippmann
