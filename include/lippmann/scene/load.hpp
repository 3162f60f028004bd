// Loads a scene from a file of any supported format, or builds a built-in one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct LoadOptions {
  std::optional<std::filesystem::path> camera_path{};  ///< a Tachyon .cam file, for .dat scenes only
  double frames_per_second = 0.0;                      ///< 0: the default rate of the file format
  /// The scene may refer to files in this folder, its subfolders, and the scene's own folder. Empty: only the scene's own
  /// folder.
  std::filesystem::path asset_root{};
  std::string animation{};  ///< name or index of the animation to play; empty: the first animation
  /// Memory limit for the decoded textures of glTF, OBJ and PLY files, at 4 bytes per texel. If they exceed it, the loader
  /// warns and halves the largest textures until all fit.
  std::uint64_t texture_bytes = std::uint64_t{1024} << 20;
  /// Diameter of the points of PLY files that contain only points, in file units. 0: derived from the spacing of the points.
  double point_size = 0.0;
  std::string variant{};  ///< name or index of the material variant; empty: the file's default variant
};

/// Loads the built-in scene `name` (builtin.hpp), or the file `name`: .gltf, .glb, .dat, .nff, .obj or .ply. Warns in `context`
/// about unsupported features. The result passes validate(). Throws Error.
Scene load_scene(const std::string& name, const LoadOptions& options, const Context& context);

/// Returns the kind of a scene without loading it, from the file name and, for PLY and glTF, the file's header or JSON. Returns
/// kPhysical for PLY and glTF files that cannot be read.
SceneKind scene_kind(const std::string& name);

/// Checks every index, size and number of a scene. Throws Error naming `where` and the invalid element.
void validate(const Scene& scene, const std::string& where);

}  // namespace lippmann
