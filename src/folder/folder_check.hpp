// Checks that a render's folder holds all recorded files unchanged, and no foreign files of frames.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "folder/journal.hpp"

namespace lippmann {

/// Returns the files in `folder` that are named like those of frames but are not in the journal, sorted, relative to `folder`.
/// Includes folders of views, unless they are symbolic links. Returns nothing for a folder that does not exist.
std::vector<std::string> foreign_files(const std::filesystem::path& folder, const FolderJournal& journal = {});

/// The finished parts of a folder according to its journal, and the differences found.
struct FolderCheck {
  int frames = 0;         ///< finished frames
  std::size_t files = 0;  ///< files of finished frames and of strips of unfinished frames, job.toml, report.json, videos and
                          ///< files in the companion folders
  std::vector<int> unfinished;  ///< requested frames that have not been rendered
  /// The missing strips of partly rendered frames, from 0 at the top.
  std::map<int, std::vector<int>> strips_left;
  std::map<std::string, std::vector<int>> unfinished_beside;  ///< unfinished frames of renders in subfolders, by folder name
  std::vector<int> joinable;                                  ///< missing or damaged frames whose strips are all present
  std::vector<std::string> missing;                           ///< files that do not exist
  std::vector<std::string> damaged;                           ///< files with other bytes, or not regular files
  std::vector<std::string> foreign;  ///< see foreign_files(); leftovers of unfinished frames do not count
  bool passed() const {
    return unfinished.empty() && unfinished_beside.empty() && missing.empty() && damaged.empty() && foreign.empty();
  }
};

/// Reads every file in the journals of `folder` and its companion folders. Throws Error if there is no journal, or a damaged
/// one.
FolderCheck check_folder(const std::filesystem::path& folder);

}  // namespace lippmann
