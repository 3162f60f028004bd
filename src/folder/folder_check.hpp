// Checks that the folder of a render holds all recorded files unchanged, and no foreign files of frames.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "folder/journal.hpp"

namespace lippmann {

/// Returns the files that are named like files of frames but are not in the journal, sorted and relative to `folder`.
/// Folders of views are searched too, unless they are symbolic links. Returns nothing if the folder does not exist.
std::vector<std::string> foreign_files(const std::filesystem::path& folder, const FolderJournal& journal = {});

struct FolderCheck {
  int frames = 0;
  /// Number of recorded files: files of finished frames, strips of unfinished frames, job.toml, report.json, videos, and the
  /// files in the companion folders (FolderJournal::companions).
  std::size_t files = 0;
  std::vector<int> unfinished;  ///< requested frames that have not been rendered
  /// Missing strips of partly rendered frames, by frame. Strip 0 is at the top.
  std::map<int, std::vector<int>> strips_left;
  /// Unfinished frames of renders in subfolders, by the name of the subfolder.
  std::map<std::string, std::vector<int>> unfinished_beside;
  /// Missing or damaged frames that can be joined, because all their strips exist.
  std::vector<int> joinable;
  std::vector<std::string> missing;  ///< recorded files that do not exist
  std::vector<std::string> damaged;  ///< files whose bytes differ from the record, or that are not regular files
  std::vector<std::string> foreign;  ///< see foreign_files(); without leftovers of unfinished frames
  bool passed() const {
    return unfinished.empty() && unfinished_beside.empty() && missing.empty() && damaged.empty() && foreign.empty();
  }
};

/// Reads every file that the journals of `folder` and its companion folders record. Throws Error if the journal is
/// missing or damaged.
FolderCheck check_folder(const std::filesystem::path& folder);

}  // namespace lippmann
