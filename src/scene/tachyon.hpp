// Reads Tachyon scene files (.dat) and camera paths (.cam): what docs/reference/tachyon.md says they mean, as a Scene.
//
// Tachyon's world is left-handed (right = up x view), ours is right-handed: every point, direction and axis is mirrored in the
// plane z = 0 on import, and nothing else knows of it.
#pragma once

#include <filesystem>
#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Frames per second of a camera path, which does not say; Tachyon itself only writes numbered pictures.
inline constexpr double kTachyonFramesPerSecond = 25.0;

/// Side files (INCLUDE, TPOLYFILE, image maps) are looked for in the .dat file's folder and, where it is given, below
/// asset_root. A camera path of N lines gives N + 1 frames, the last line twice, so that frame numbers agree with Tachyon's own
/// pictures. origin: Scene::origin. Throws Error, naming file, line and keyword, for what cannot be read and for what a Scene
/// cannot express.
Scene load_tachyon(const std::filesystem::path& path, const std::optional<std::filesystem::path>& camera_path,
                   const Context& context, double frames_per_second = kTachyonFramesPerSecond,
                   const std::filesystem::path& asset_root = {}, const Vec3d& origin = Vec3d(0.0));

}  // namespace lippmann
