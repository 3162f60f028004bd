// Fetches what a URI of a glTF file refers to: data within the URI, or a file in the scene's own folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf/report.hpp"

namespace lippmann::gltf {

/// A data URI is decoded; anything else has to be the relative path of a regular file below `folder` (after symbolic links are
/// followed) of at most `limit` bytes. Throws Error at `element` otherwise.
std::vector<std::byte> fetch(std::string_view uri, const std::filesystem::path& folder, std::uint64_t limit,
                             std::string_view element, const Report& report);

}  // namespace lippmann::gltf
