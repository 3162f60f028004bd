// Reads a whole file. Throws Error naming it if there is none, it is no regular file, or has more than 4 GB.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace lippmann {

std::vector<std::byte> read_file_bytes(const std::filesystem::path& path);

}  // namespace lippmann
