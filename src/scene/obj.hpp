// Reads Wavefront OBJ files (.obj) and their materials (.mtl): what docs/guide/scenes.md says they mean, as a Scene without
// camera.
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann {

/// Materials and textures are looked for in the file's folder and, where it is given, below asset_root; the context is warned
/// of those that are missing or lie elsewhere, and of those that are halved (LoadOptions::texture_bytes). origin:
/// Scene::origin. Throws Error, naming file and line, for what cannot be read.
Scene load_obj(const std::filesystem::path& path, const Context& context, const std::filesystem::path& asset_root = {},
               std::uint64_t texture_bytes = LoadOptions{}.texture_bytes, const Vec3d& origin = Vec3d(0.0));

}  // namespace lippmann
