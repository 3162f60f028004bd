// Reads a scene from a file or builds a built-in one: the one place that knows which format is whose.
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
  std::filesystem::path asset_root{};  ///< the files that a scene names may lie below it; empty: in the scene's folder only
  std::string animation{};             ///< name or index of the one to show, of files that hold several; empty: the first
  /// Decoded textures of glTF, OBJ and PLY take so much at most, 4 bytes a texel: the largest are halved until they do, which
  /// is a warning. Tables for rendering take 2.7 times as much besides.
  std::uint64_t texture_bytes = std::uint64_t{1024} << 20;
  double point_size =
      0.0;                ///< diameter of the points of a PLY file of points alone, in its units; 0: chosen from their spacing
  std::string variant{};  ///< name or index of the set of materials, of files that hold several; empty: the file's default
};

/// `name` is a built-in scene (builtin.hpp) or a file: .gltf, .glb, .dat, .nff, .obj, .ply. Throws Error; what is read but not
/// supported is a warning in `context`. The result has passed validate().
Scene load_scene(const std::string& name, const LoadOptions& options, const Context& context);

/// Returns the kind of the scene with this name without loading it, from its ending and, for PLY and glTF, from the file's
/// header or JSON. A file that cannot be read counts as physical.
SceneKind scene_kind(const std::string& name);

/// Checks every index, size and number of a scene (finite vertices, triangle indices, parents before children, radii > 0).
/// Throws Error naming `where` and the element.
void validate(const Scene& scene, const std::string& where);

}  // namespace lippmann
