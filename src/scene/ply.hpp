// Reads PLY files (.ply), Stanford's polygon format, text and binary: what docs/scenes.md says they mean, as a Scene without
// camera.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// origin: Scene::origin; splats, whose numbers are floats, do without. Throws Error, naming the file and the header's line or
/// the element, for what cannot be read.
Scene load_ply(const std::filesystem::path& path, const Context& context, const Vec3d& origin = Vec3d(0.0));

/// The same of a file's contents; `name` is what errors call it.
Scene parse_ply(const std::string& name, const std::string& contents, const Context& context, const Vec3d& origin = Vec3d(0.0));

/// Whether a file's header describes splats (ply/splats.hpp). What cannot be read is none.
bool is_ply_of_splats(const std::filesystem::path& path);

}  // namespace lippmann
