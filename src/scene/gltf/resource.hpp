// Fetches the target of a URI in a glTF file: embedded data, or a permitted file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf/report.hpp"
#include "scene/side_file.hpp"

namespace lippmann::gltf {

/// Decodes a data URI, or reads a regular file in `folders` (after resolving symbolic links) of at most `limit` bytes. Throws
/// Error at `element` for anything else.
std::vector<std::byte> fetch(std::string_view uri, const SideFolders& folders, std::uint64_t limit, std::string_view element,
                             const Report& report);

/// Returns why a URI cannot be fetched. Returns an empty text if it can, or if it holds data. Errors about the folder itself
/// name `where`.
std::string uri_problem(std::string_view uri, const SideFolders& folders, const std::string& where);

}  // namespace lippmann::gltf
