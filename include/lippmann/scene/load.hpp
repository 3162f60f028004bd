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
  double frames_per_second = 0.0;                      ///< 0: the format's default
  /// Another folder that, with its subfolders, may contain files the scene refers to. Empty: only the scene's own folder may.
  std::filesystem::path asset_root{};
  std::string animation{};  ///< name or index of the animation to play; empty: the first
  /// Memory limit for the decoded textures of glTF, OBJ and PLY files, at 4 bytes per texel. If the textures exceed it, the
  /// largest ones are halved until all fit, with a warning. Lookup tables for rendering take another 2.7 times as much.
  std::uint64_t texture_bytes = std::uint64_t{1024} << 20;
  /// Diameter of the points of PLY files that contain only points, in file units. 0: derived from their spacing.
  double point_size = 0.0;
  std::string variant{};  ///< name or index of the material variant; empty: the file's default
};

/// Loads the built-in scene `name` (builtin.hpp) or a file: .gltf, .glb, .dat, .nff, .obj, .ply. Unsupported features become
/// warnings in `context`. The result passes validate(). Throws Error.
Scene load_scene(const std::string& name, const LoadOptions& options, const Context& context);

/// Returns the kind of a scene without loading it: from the file name and, for PLY and glTF, from the file's header or JSON.
/// Returns kPhysical for unreadable files.
SceneKind scene_kind(const std::string& name);

/// Checks every index, size and number of a scene (for example: finite vertices, valid triangle indices, parents before
/// children, radii > 0). Throws Error naming `where` and the element.
void validate(const Scene& scene, const std::string& where);

}  // namespace lippmann
