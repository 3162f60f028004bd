// Reads Eric Haines' Neutral File Format (.nff) as a Scene; docs/guide/scenes.md describes the interpretation.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Loads a file as a scene with one frame. The scene has no camera if the file has no view. `origin` is Scene::origin. Throws
/// Error naming file and line.
Scene load_nff(const std::filesystem::path& path, const Context& context, const Vec3d& origin = Vec3d(0.0));

Scene parse_nff(const std::string& name, std::string text, const Context& context, const Vec3d& origin = Vec3d(0.0));

}  // namespace lippmann
