#pragma once

#include <filesystem>
#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Default frame rate of camera paths, which do not state a rate.
inline constexpr double kTachyonFramesPerSecond = 25.0;

/// Loads a file. The files that it refers to (INCLUDE, TPOLYFILE, image maps) may lie in the .dat file's folder or below
/// asset_root, if given. A camera path of N lines gives N + 1 frames, the last two of which are equal, as in Tachyon. `origin`
/// is Scene::origin. Throws Error naming file, line and keyword, also for features that a Scene cannot express.
Scene load_tachyon(const std::filesystem::path& path, const std::optional<std::filesystem::path>& camera_path,
                   const Context& context, double frames_per_second = kTachyonFramesPerSecond,
                   const std::filesystem::path& asset_root = {}, const Vec3d& origin = Vec3d(0.0));

}  // namespace lippmann
