// Brings together what runs of one job have rendered into folders of their own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lippmann {

struct JoinedFolders {
  std::vector<int> frames;  ///< that were taken over, ascending
  std::vector<std::string>
      not_as_written;  ///< files of the others that are damaged or missing: their frames or strips were left out
};

/// Takes over the frames of `others`, and strips of those that are in pieces, that `folder` has not finished, or not as they
/// were written: their files are linked, or copied where that cannot be, and recorded; the other folders stay as they are.
/// `folder` is made if it is not there. Throws Error for folders that hold no render or those of different jobs, and for files
/// that cannot be written.
JoinedFolders join_folders(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& others);

}  // namespace lippmann
