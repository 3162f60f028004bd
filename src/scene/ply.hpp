// Reads PLY files (.ply), Stanford's polygon format, text and binary: what docs/guide/scenes.md says they mean, as a Scene
// without camera.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/side_file.hpp"

namespace lippmann {

struct PlyOptions {
  SideFolders folders{};                                      ///< where its pictures may lie
  std::uint64_t texture_bytes = LoadOptions{}.texture_bytes;  ///< as LoadOptions has it
  Vec3d origin{0.0};                                          ///< Scene::origin
  double point_size = 0.0;                                    ///< as LoadOptions has it
};

/// Throws Error, naming the file and the header's line or the element, for what cannot be read. What is not read is a warning
/// that names it. The folder of `options.folders` is that of the file.
Scene load_ply(const std::filesystem::path& path, const Context& context, PlyOptions options = {});

/// The same of a file's contents; `name` is what errors call it.
Scene parse_ply(const std::string& name, const std::string& contents, const Context& context, const PlyOptions& options = {});

/// Whether a file is shown as splats, by its header: splats, or points with colours. A file that cannot be read is not.
bool is_ply_of_splats(const std::filesystem::path& path);

}  // namespace lippmann
