// Reads Tachyon scene files (.dat) and camera paths (.cam) as a Scene; docs/reference/tachyon.md describes the interpretation.
//
// Tachyon's world is left-handed (right = up x view), ours is right-handed. The importer mirrors every point, direction and
// axis in the plane z = 0.
#pragma once

#include <filesystem>
#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Frame rate of camera paths, which do not state one; Tachyon itself only writes numbered images.
inline constexpr double kTachyonFramesPerSecond = 25.0;

/// Loads a file. Searches side files (INCLUDE, TPOLYFILE, image maps) in the .dat file's folder and below asset_root, if given.
/// A camera path of N lines gives N + 1 frames, with the last line repeated, so that frame numbers match Tachyon's own images.
/// origin: see Scene::origin. Throws Error naming file, line and keyword, also if the file uses features that a Scene cannot
/// express.
Scene load_tachyon(const std::filesystem::path& path, const std::optional<std::filesystem::path>& camera_path,
                   const Context& context, double frames_per_second = kTachyonFramesPerSecond,
                   const std::filesystem::path& asset_root = {}, const Vec3d& origin = Vec3d(0.0));

}  // namespace lippmann
