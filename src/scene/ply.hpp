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
};

/// Throws Error, naming the file and the header's line or the element, for what cannot be read. What is not read is a warning
/// that names it. `origin` is PlyOptions::origin.
Scene load_ply(const std::filesystem::path& path, const Context& context, const std::filesystem::path& asset_root,
               std::uint64_t texture_bytes, const Vec3d& origin = Vec3d(0.0));

/// The same of a file's contents; `name` is what errors call it.
Scene parse_ply(const std::string& name, const std::string& contents, const Context& context, const PlyOptions& options = {});

/// Whether a file's header describes splats (ply/splats.hpp). What cannot be read is none.
bool is_ply_of_splats(const std::filesystem::path& path);

}  // namespace lippmann
