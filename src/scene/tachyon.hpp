// Reads Tachyon scene files (.dat) and camera paths (.cam) as a Scene. docs/reference/tachyon.md describes the interpretation.
//
// Tachyon's world is left-handed (right = up x view), but a Scene is right-handed. Therefore the importer mirrors every point,
// direction and axis in the plane z = 0.
#pragma once

#include <filesystem>
#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Default frame rate of camera paths, which do not state a rate.
inline constexpr double kTachyonFramesPerSecond = 25.0;

/// Loads a file. The files that it refers to (INCLUDE, TPOLYFILE, image maps) may lie in the .dat file's folder or below
/// asset_root, if given. A camera path of N lines gives N + 1 frames, so that frame numbers match Tachyon's own images; the
/// last two frames are equal. `origin` is Scene::origin. Throws Error naming file, line and keyword. Features that a Scene
/// cannot express are also errors.
Scene load_tachyon(const std::filesystem::path& path, const std::optional<std::filesystem::path>& camera_path,
                   const Context& context, double frames_per_second = kTachyonFramesPerSecond,
                   const std::filesystem::path& asset_root = {}, const Vec3d& origin = Vec3d(0.0));

}  // namespace lippmann
