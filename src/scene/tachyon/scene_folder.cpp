#include "scene/tachyon/scene_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "core/error.hpp"
#include "scene/tachyon/lexer.hpp"

namespace lippmann::tachyon {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kAcceptedNames = "a file in the scene's own folder or below it, by a relative path without '..'";

/// Whether `path` is `folder` or lies below it; both without links and dots.
bool lies_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

SceneFolder::SceneFolder(const fs::path& scene_file)
    : folder_(scene_file.has_parent_path() ? scene_file.parent_path() : fs::path(".")) {}

fs::path SceneFolder::resolve(std::string_view name, const std::string& where) const {
  const Error outside(where, fmt::format("{} is not a file of this scene's folder", shown(name)), std::string(kAcceptedNames));
  const fs::path relative(name);
  if (name.find('\0') != name.npos || relative.is_absolute()) throw outside;
  if (std::find(relative.begin(), relative.end(), "..") != relative.end()) throw outside;
  std::error_code failure;
  const fs::path folder = fs::canonical(folder_, failure);
  if (failure) throw Error(where, fmt::format("the folder {} cannot be read: {}", folder_.string(), failure.message()));
  const fs::path target = fs::weakly_canonical(folder / relative, failure);
  if (failure || !lies_in(target, folder)) throw outside;
  return folder_ / relative;
}

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
