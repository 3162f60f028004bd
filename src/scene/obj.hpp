// Reads Wavefront OBJ files (.obj) and their materials (.mtl): what docs/scenes.md says they mean, as a Scene without camera.
#pragma once

#include <filesystem>

#include "core/context.hpp"
#include "scene/scene.hpp"

namespace lippmann {

/// Materials and textures are looked for beside the file and never outside its folder; where they are missing, the context is
/// warned. Throws Error, naming file and line, for what cannot be read.
Scene load_obj(const std::filesystem::path& path, const Context& context);

}  // namespace lippmann
