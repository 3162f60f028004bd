#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace lippmann::test {

/// Returns an empty string if the file does not exist.
inline std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace lippmann::test
