// Computes the size and the checksum (XXH3, 64 bits) of a file. The checksum detects damage, not manipulation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace lippmann {

struct FileChecksum {
  std::uint64_t bytes = 0;
  std::string xxh3;
  bool operator==(const FileChecksum&) const = default;
};

FileChecksum checksum_of(std::span<const std::byte> bytes);

/// Returns nothing if the file does not exist, is not a regular file, or cannot be read.
std::optional<FileChecksum> file_checksum(const std::filesystem::path& path);

}  // namespace lippmann
