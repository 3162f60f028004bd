// Reads PLY files (.ply), Stanford's polygon format, as a Scene without cameras. Supports text and binary files.
// docs/guide/scenes.md describes the interpretation.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/side_file.hpp"

namespace lippmann {

struct PlyOptions {
  SideFolders folders{};                                      ///< folders that may contain the file's textures
  std::uint64_t texture_bytes = LoadOptions{}.texture_bytes;  ///< as in LoadOptions
  Vec3d origin{0.0};                                          ///< see Scene::origin
  double point_size = 0.0;                                    ///< as in LoadOptions
};

/// Loads a file. The file's folder replaces options.folders.folder. Warns about unsupported elements. Throws Error naming the
/// file and either the header's line or the element.
Scene load_ply(const std::filesystem::path& path, const Context& context, PlyOptions options = {});

/// Same as load_ply(), for the contents of a file. `name` names the file in messages.
Scene parse_ply(const std::string& name, const std::string& contents, const Context& context, const PlyOptions& options = {});

/// Returns whether load_ply() represents the file as splats, because the header describes splats or coloured points. Returns
/// false for unreadable files.
bool is_ply_splat_file(const std::filesystem::path& path);

}  // namespace lippmann
