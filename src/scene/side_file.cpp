#include "scene/side_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/error.hpp"
#include "core/printable.hpp"

namespace lippmann {

namespace fs = std::filesystem;

namespace {

/// Whether `path` is `folder` or lies below it; both without links and dots.
bool lies_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

fs::path side_file(const fs::path& folder, std::string_view name, const std::string& where) {
  const Error outside(where, fmt::format("{} is not a file of this scene's folder", shown(name)),
                      "a file in the scene's own folder or below it, by a relative path without '..'");
  const fs::path relative(name), base = folder.empty() ? fs::path(".") : folder;
  if (name.empty() || name.find('\0') != name.npos || relative.is_absolute()) throw outside;
  if (std::find(relative.begin(), relative.end(), "..") != relative.end()) throw outside;
  std::error_code failure;
  const fs::path home = fs::canonical(base, failure);
  if (failure) throw Error(where, fmt::format("the folder {} cannot be read: {}", base.string(), failure.message()));
  const fs::path target = fs::weakly_canonical(home / relative, failure);
  if (failure || !lies_in(target, home)) throw outside;
  return base / relative;
}

}  // namespace lippmann
