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

struct Container {
  std::string_view json;
  std::optional<Bytes> binary;
};

/// Splits the contents of a file. Contents that begin with "glTF" are a binary container (.glb); all other contents are JSON.
/// Throws Error if a .glb is shorter than its header states.
Container split_container(Bytes contents, Report& report);

/// Returns the contents of a regular file of at most `limit` bytes. Error messages name `element`, the element of the scene
/// that refers to the file. `element` is empty if the file is the scene itself. Throws Error.
std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t limit, std::string_view element,
                                 const Report& report);

}  // namespace lippmann::gltf
