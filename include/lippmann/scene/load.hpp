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
  std::string variant{};  ///< name or index of the set of materials, of files that hold several; empty: the file's default
};

/// `name` is a built-in scene (builtin.hpp) or a file: .gltf, .glb, .dat, .nff, .obj, .ply. Throws Error; what is read but not
/// supported is a warning in `context`. The result has passed validate().
Scene load_scene(const std::string& name, const LoadOptions& options, const Context& context);

/// Whether `name` is a file of a format that describes surfaces and light physically (glTF, OBJ, PLY), by its ending: no
/// built-in scene, and none of the formats that describe Whitted's shading (Tachyon, NFF).
bool is_physical_format(const std::string& name);

/// Returns the kind of the scene with this name, from its ending. Files that may hold splats are opened to find out.
SceneKind scene_kind(const std::string& name);

/// Whether `name` is a file of splats (3D Gaussians) alone, PLY by its header or glTF by its JSON. What cannot be read is none.
bool is_splat_file(const std::string& name);

/// Checks every index, size and number of a scene (finite vertices, triangle indices, parents before children, radii > 0).
/// Throws Error naming `where` and the element.
void validate(const Scene& scene, const std::string& where);

}  // namespace lippmann
