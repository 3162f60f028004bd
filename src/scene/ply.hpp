#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/side_file.hpp"

namespace lippmann {

struct PlyOptions {
  SideFolders folders{};
  std::uint64_t texture_bytes = LoadOptions{}.texture_bytes;
  Vec3d origin{0.0};
  double point_size = 0.0;
};

/// Loads a file. The file's folder replaces options.folders.folder. Warns about unsupported elements. Throws Error naming the
/// file and either the header's line or the element.
Scene load_ply(const std::filesystem::path& path, const Context& context, PlyOptions options = {});

Scene parse_ply(const std::string& name, const std::string& contents, const Context& context, const PlyOptions& options = {});

/// Returns whether the header describes splats or coloured points, which load_ply() represents as splats. Returns false for
/// unreadable files.
bool is_ply_splat_file(const std::filesystem::path& path);

}  // namespace lippmann
