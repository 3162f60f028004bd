// Fetches what a URI of a glTF file refers to: data within the URI, or a file that the scene may name.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf/report.hpp"
#include "scene/side_file.hpp"

namespace lippmann::gltf {

/// A data URI is decoded; anything else has to be the path of a regular file in `folders` (after symbolic links are followed)
/// of at most `limit` bytes. Throws Error at `element` otherwise.
std::vector<std::byte> fetch(std::string_view uri, const SideFolders& folders, std::uint64_t limit, std::string_view element,
                             const Report& report);

/// Why there is no such file to fetch; empty: there is one, or the URI holds data. `where`: for Errors about the folder itself.
std::string uri_problem(std::string_view uri, const SideFolders& folders, const std::string& where);

}  // namespace lippmann::gltf
