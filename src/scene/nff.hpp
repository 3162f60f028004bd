// Reads Eric Haines' Neutral File Format (.nff): what docs/guide/scenes.md says it means, as a Scene.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Throws Error, naming file and line, for what cannot be read. The scene has one frame; without a view it has no camera.
/// origin: Scene::origin.
Scene load_nff(const std::filesystem::path& path, const Context& context, const Vec3d& origin = Vec3d(0.0));

/// The same of a text; `name` is what errors call it.
Scene parse_nff(const std::string& name, std::string text, const Context& context, const Vec3d& origin = Vec3d(0.0));

}  // namespace lippmann
