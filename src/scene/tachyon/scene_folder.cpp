#include "scene/tachyon/scene_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "core/error.hpp"
#include "scene/side_file.hpp"

namespace lippmann::tachyon {

namespace fs = std::filesystem;

SceneFolder::SceneFolder(const fs::path& scene_file)
    : folder_(scene_file.has_parent_path() ? scene_file.parent_path() : fs::path(".")) {}

fs::path SceneFolder::resolve(std::string_view name, const std::string& where) const { return side_file(folder_, name, where); }

std::string SceneFolder::read_text(const fs::path& file, const std::string& where) {
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) {
    const bool missing = !fs::exists(file, failure);
    throw Error(where, fmt::format("{} {}", file.string(), missing ? "does not exist" : "is not a regular file"));
  }
  const std::uintmax_t size = fs::file_size(file, failure);
  if (failure) throw Error(where, fmt::format("{} cannot be read: {}", file.string(), failure.message()));
  if (size > budget_bytes_)
    throw Error(where, "the scene's files are too large", "at most 1 GiB of text, included files counted");
  budget_bytes_ -= static_cast<std::size_t>(size);
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
    throw Error(where, fmt::format("{} cannot be read", file.string()));
  return text;
}

}  // namespace lippmann::tachyon
