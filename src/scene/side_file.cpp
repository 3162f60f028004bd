#include "scene/side_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

namespace fs = std::filesystem;

namespace {

bool lies_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

fs::path canonical_folder(const fs::path& folder, const std::string& where) {
  if (folder.empty()) return {};
  std::error_code failure;
  fs::path home = fs::canonical(folder, failure);
  if (failure) throw Error(where, fmt::format("the folder {} cannot be read: {}", folder.string(), failure.message()));
  return home;
}

fs::path folder_of(const SideFolders& folders) { return folders.folder.empty() ? fs::path(".") : folders.folder; }

bool is_allowed(const SideFolders& folders, std::string_view name, const std::string& where) {
  if (name.empty() || name.find('\0') != name.npos) return false;
  const fs::path home = canonical_folder(folder_of(folders), where), root = canonical_folder(folders.asset_root, where);
  const auto allowed = [&](const fs::path& path) { return lies_in(path, home) || (!root.empty() && lies_in(path, root)); };
  if (!allowed((home / name).lexically_normal())) return false;
  std::error_code failure;
  const fs::path target = fs::weakly_canonical(home / name, failure);
  return !failure && allowed(target);
}

}  // namespace

fs::path side_file(const SideFolders& folders, std::string_view name, const std::string& where) {
  if (!is_allowed(folders, name, where))
    throw Error(where, fmt::format("{} is outside the scene's folder", shown(name)),
                "a file in or below the scene's folder; `asset-root` DIR also allows files below DIR");
  return folder_of(folders) / name;
}

SideFile find_side_file(const SideFolders& folders, std::string_view name, const std::string& where) {
  if (!is_allowed(folders, name, where))
    return {{}, fmt::format("{} is outside the scene's folder (`asset-root` DIR allows files below DIR)", shown(name))};
  const fs::path path = folder_of(folders) / name;
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return {{}, fmt::format("{} does not exist", shown(name))};
  return {path, {}};
}

}  // namespace lippmann
