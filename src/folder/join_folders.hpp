// Merges folders that runs of one job have rendered into.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lippmann {

struct JoinedFolders {
  std::vector<int> frames;  ///< in ascending order
  /// Damaged or missing files of `others`. Their frames or strips were skipped.
  std::vector<std::string> not_as_written;
};

/// Copies or links the frames and strips of `others` that are missing or damaged in `folder`, and records them. Makes
/// `folder` if necessary. Throws Error for folders without a render, for folders of different jobs, and for files that
/// cannot be written.
JoinedFolders join_folders(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& others);

}  // namespace lippmann
