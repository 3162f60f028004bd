#include "core/folder.hpp"

#include <system_error>
#include <utility>

#include "core/platform.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  if (folder.empty()) return;
  std::error_code problem;
  std::vector<fs::path> changed;
  for (fs::path there = folder; !there.empty() && !fs::exists(there, problem); there = there.parent_path())
    changed.push_back(there.parent_path());
  fs::create_directories(folder, problem);
  if (problem)
    throw Error(folder.string(), "the folder cannot be made (" + problem.message() + ")", "a folder that can be written into");
  for (const fs::path& above : changed) platform::sync_folder(above);
}

void remove_if_there(const fs::path& path) {
  std::error_code problem;
  fs::remove(path, problem);
  if (problem) throw Error(path.string(), "cannot be removed (" + problem.message() + ")", "a folder that can be written into");
}

NewFolder::NewFolder(fs::path folder) {
  std::error_code ignored;
  const fs::path wanted = folder;
  for (; !folder.empty() && !fs::exists(folder, ignored); folder = folder.parent_path()) made_.push_back(folder);
  make_folder(wanted);
}

NewFolder::~NewFolder() {
  std::error_code problem;
  for (const fs::path& folder : made_)
    if (fs::is_directory(folder, problem))
      fs::remove(folder, problem);  // fails for folders that are not empty, which is intended
}

}  // namespace lippmann
