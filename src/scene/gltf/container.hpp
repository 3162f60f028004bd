// Takes a glTF file apart into its JSON text and its binary chunk.
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

/// Views into the contents that were given.
struct Container {
  std::string_view json;
  std::optional<Bytes> binary;  ///< the BIN chunk of a .glb
};

/// Contents that begin with "glTF" are a binary container, others are JSON. A .glb that is shorter than it says is an Error.
Container split_container(Bytes contents, Report& report);

/// Reads a whole regular file of at most `limit` bytes; `element` names who wants it in messages (empty: the scene itself).
std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t limit, std::string_view element,
                                 const Report& report);

}  // namespace lippmann::gltf
