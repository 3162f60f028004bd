// Reads a whole file. Throws Error naming it if there is none, it is no regular file, or has more than 4 GB, and for a file of
// a render that has other bytes than the render wrote (core/recorded_file.hpp).
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace lippmann {

std::vector<std::byte> read_file_bytes(const std::filesystem::path& path);

/// The same of a file that was written just now, which no journal has yet.
std::vector<std::byte> read_new_file_bytes(const std::filesystem::path& path);

}  // namespace lippmann
