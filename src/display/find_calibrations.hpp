// Finds the calibrations of displays that are plugged in: a Looking Glass shows itself as a small drive with
// LKG_calibration/visual.json on it.
#pragma once

#include <filesystem>
#include <vector>

namespace lippmann {

/// Where drives are mounted: /media, /run/media, /mnt (Linux), /Volumes (macOS).
std::vector<std::filesystem::path> usual_mount_points();

/// The visual.json files of drives below these folders, up to two folders deep (/media/user/drive), sorted; those in
/// LKG_calibration, and those beside a drive's other files. Folders that are not there or cannot be read hold none.
std::vector<std::filesystem::path> find_calibrations(const std::vector<std::filesystem::path>& mount_points);

}  // namespace lippmann
