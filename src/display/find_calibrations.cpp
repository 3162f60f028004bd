#include "display/find_calibrations.hpp"

#include <algorithm>
#include <system_error>

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr int kFoldersDeep = 2;

void look_in(const fs::path& folder, int deeper, std::vector<fs::path>& found) {
  std::error_code unreadable;
  for (const fs::path& file : {folder / "LKG_calibration" / "visual.json", folder / "visual.json"})
    if (fs::is_regular_file(file, unreadable)) found.push_back(file);
  if (deeper == 0) return;
  for (fs::directory_iterator entry(folder, unreadable), end; !unreadable && entry != end; entry.increment(unreadable)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && entry->path().filename() != "LKG_calibration")
      look_in(entry->path(), deeper - 1, found);
  }
}

}  // namespace

std::vector<fs::path> usual_mount_points() { return {"/media", "/run/media", "/mnt", "/Volumes"}; }

std::vector<fs::path> find_calibrations(const std::vector<fs::path>& mount_points) {
  std::vector<fs::path> found;
  for (const fs::path& mount_point : mount_points) look_in(mount_point, kFoldersDeep, found);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace lippmann
