#include "scene/text_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "core/error.hpp"

namespace lippmann {

namespace fs = std::filesystem;

std::string read_text_file(const fs::path& file, const std::string& where, std::size_t limit_bytes,
                           const std::string& accepted) {
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) {
    const bool missing = !fs::exists(file, failure);
    throw Error(where, fmt::format("{} {}", file.string(), missing ? "does not exist" : "is not a regular file"));
  }
  const std::uintmax_t size = fs::file_size(file, failure);
  if (failure) throw Error(where, fmt::format("{} cannot be read: {}", file.string(), failure.message()));
  if (size > limit_bytes) throw Error(where, "the scene's files are too large", accepted);
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
    throw Error(where, fmt::format("{} cannot be read", file.string()));
  return text;
}

}  // namespace lippmann
