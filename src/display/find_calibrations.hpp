// Finds the calibrations of connected displays. A Looking Glass appears as a small drive that contains
// LKG_calibration/visual.json.
#pragma once

#include <filesystem>
#include <vector>

namespace lippmann {

/// Returns the folders where drives are mounted: /media, /run/media, /mnt (Linux), /Volumes (macOS).
std::vector<std::filesystem::path> usual_mount_points();

/// Returns the paths of the visual.json files on all drives, sorted. Drives are folders up to two levels below the mount points
/// (/media/user/drive). The file is in LKG_calibration or in the root of a drive. Ignores folders that are missing or
/// unreadable.
std::vector<std::filesystem::path> find_calibrations(const std::vector<std::filesystem::path>& mount_points);

}  // namespace lippmann
