// Finishes a job that was rendered in parts: checks it and writes the files that need all frames.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "folder/folder_check.hpp"
#include "folder/join_folders.hpp"
#include "job/animation.hpp"

namespace lippmann {

struct FinishedAnimation {
  JoinedFolders joined;
  FolderCheck check;                   ///< the folder before it was finished
  std::vector<int> to_render;          ///< frames that are missing or damaged and cannot be joined from strips
  std::optional<RenderReport> report;  ///< report of the whole folder; nullopt if frames are missing
  bool has_single = true;              ///< false if the job needs a render in kSingleFolder and that render is not complete
};

/// Takes over the frames of the folders `join` (join_folders) and reads all files of the folder. If all frames of the job
/// exist, whole or as strips, joins the strips and writes the videos, job.toml and report.json. Renders nothing. Finishes the
/// job's render in kSingleFolder in the same way. The job is read from the folder's job.toml, or else from the one in the first
/// folder of `join`. Throws Error for folders without a render, and for files that cannot be written.
FinishedAnimation finish_animation(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& join,
                                   const Context& context, const RenderObserver& observer = {});

/// Does the same, with a function that writes the videos and the two files of a complete folder.
using CompleteFolder = std::function<RenderReport(const RenderParams&)>;
FinishedAnimation finish_folder(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& join,
                                const CompleteFolder& complete);

}  // namespace lippmann
