#pragma once

#include <filesystem>
#include <vector>

namespace lippmann {

std::vector<std::filesystem::path> usual_mount_points();

/// Returns the paths of the visual.json files on all drives, sorted. Drives are folders up to two levels below the mount points
/// (/media/user/drive). Ignores folders that are missing or unreadable.
std::vector<std::filesystem::path> find_calibrations(const std::vector<std::filesystem::path>& mount_points);

}  // namespace lippmann
