// The size and the checksum of a file's bytes (XXH3, 64 bits), which find damage; they are no protection against anybody.
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
  std::string xxh3;  ///< 16 hexadecimal digits
  bool operator==(const FileChecksum&) const = default;
};

/// What a file of these bytes has.
FileChecksum checksum_of(std::span<const std::byte> bytes);

/// None if there is no such file, it is no regular file (a FIFO is not waited for), or it cannot be read.
std::optional<FileChecksum> file_checksum(const std::filesystem::path& path);

}  // namespace lippmann
