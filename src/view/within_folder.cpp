#include "view/within_folder.hpp"

#include <algorithm>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

bool leads_out(const fs::path& root, const fs::path& file) {
  std::error_code problem;
  const fs::path real = fs::weakly_canonical(file, problem);
  if (problem) return true;
  return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first != root.end();
}

}  // namespace

fs::path shown_root(const fs::path& in) {
  std::error_code problem;
  const fs::path real = fs::canonical(in, problem);
  if (problem) throw Error(in.string(), "there is no such file or folder");
  return fs::is_directory(real, problem) ? real : real.parent_path();
}

void require_within(const fs::path& root, const fs::path& file) {
  const auto refuse = [&](const fs::path& path) {
    throw Error(path.string(), "is a link that leads out of " + root.string(), "files that lie in the folder that is shown");
  };
  if (leads_out(root, file)) refuse(file);
  std::error_code ignored;
  if (!fs::is_directory(file, ignored)) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(file, ignored))
    if (leads_out(root, entry.path())) refuse(entry.path());
}

}  // namespace lippmann
