#include "image/file_bytes.hpp"

#include <cstdint>
#include <fstream>

#include "core/recorded_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

namespace fs = std::filesystem;

std::vector<std::byte> read_file_bytes(const fs::path& path) {
  std::vector<std::byte> bytes = read_new_file_bytes(path);
  require_as_recorded(path, bytes);
  return bytes;
}

std::vector<std::byte> read_new_file_bytes(const fs::path& path) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{4} << 30;
  std::error_code problem;
  if (!fs::exists(path, problem)) throw Error(path.string(), "there is no such file");
  if (!fs::is_regular_file(path, problem)) throw Error(path.string(), "is not a file");
  const std::uintmax_t size = fs::file_size(path, problem);
  if (problem) throw Error(path.string(), "cannot be read (" + problem.message() + ")");
  if (size > kMaxBytes) throw Error(path.string(), "is too large", "at most 4 GB");
  std::vector<std::byte> bytes(size);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file) throw Error(path.string(), "cannot be read");
  return bytes;
}

}  // namespace lippmann
