#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf/report.hpp"
#include "scene/side_file.hpp"

namespace lippmann::gltf {

/// Returns the bytes of a data URI, or of a regular file in `folders` of at most `limit` bytes. Symbolic links must not lead
/// out of `folders`. Throws Error at `element` if this is not possible.
std::vector<std::byte> fetch(std::string_view uri, const SideFolders& folders, std::uint64_t limit, std::string_view element,
                             const Report& report);

/// Returns the reason why a URI cannot be loaded. Returns an empty text for URIs that can be loaded and for data URIs. If the
/// folder of the scene cannot be read, throws Error at `where`.
std::string uri_problem(std::string_view uri, const SideFolders& folders, const std::string& where);

}  // namespace lippmann::gltf
