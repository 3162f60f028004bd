// Splits a glTF file into its JSON text and its binary data.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scene/gltf.hpp"
#include "scene/gltf/report.hpp"

namespace lippmann::gltf {

using Bytes = std::span<const std::byte>;

/// The parts of a file. They point into the contents that were passed to split_container().
struct Container {
  std::string_view json;
  std::optional<Bytes> binary;  ///< the BIN chunk of a .glb; none: the file has no such chunk
};

/// Splits the contents of a file. Contents that begin with "glTF" are a binary container (.glb); all other contents are JSON.
/// Throws Error if a .glb is shorter than its header states.
Container split_container(Bytes contents, Report& report);

/// Returns the contents of a regular file of at most `limit` bytes. `element` is the element that refers to the file, for
/// messages; empty: the file is the scene itself. Throws Error.
std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t limit, std::string_view element,
                                 const Report& report);

}  // namespace lippmann::gltf
