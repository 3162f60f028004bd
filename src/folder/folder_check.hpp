// Whether a render's folder still holds what the render has written there, and nothing that looks so and is not.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "folder/journal.hpp"

namespace lippmann {

/// Files in `folder` that are named as those of frames are and that the journal does not name; sorted, relative to it.
/// Folders of views are looked into, unless they are symbolic links. A folder that is not there has none.
std::vector<std::string> foreign_files(const std::filesystem::path& folder, const FolderJournal& journal = {});

/// What a folder's journal says was finished, and what of it is still so.
struct FolderCheck {
  int frames = 0;               ///< finished
  std::size_t files = 0;        ///< how many these frames and strips of others have, with job.toml, report.json, videos and
                                ///< what lies in folders that the render wrote beside them
  std::vector<int> unfinished;  ///< frames that were asked for and have not been rendered
  /// Of frames that some strips are there of, the others, from 0 at the top.
  std::map<int, std::vector<int>> strips_left;
  std::map<std::string, std::vector<int>> unfinished_beside;  ///< the same of renders in folders of this one, by their names
  std::vector<int> joinable;         ///< frames that are not there as they were written, and all of whose strips are
  std::vector<std::string> missing;  ///< there is no such file
  std::vector<std::string> damaged;  ///< other bytes, or no regular file
  std::vector<std::string> foreign;  ///< see foreign_files(); what a stopped render has left of unfinished frames is not
  bool passed() const {
    return unfinished.empty() && unfinished_beside.empty() && missing.empty() && damaged.empty() && foreign.empty();
  }
};

/// Reads every file of the journal in `folder`, and of those beside it that belong to the render. Throws Error if there is no
/// journal, or a damaged one.
FolderCheck check_folder(const std::filesystem::path& folder);

}  // namespace lippmann
