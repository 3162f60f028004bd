// Finishes a job that several runs have rendered.
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
  FolderCheck check;  ///< state of the folder before it was finished
  /// Frames that are missing or damaged, and cannot be joined from strips.
  std::vector<int> to_render;
  std::optional<RenderReport> report;  ///< report of the whole folder; nullopt if frames are missing
  /// False if the job also needs a render of a single view (in kSingleFolder) that is not complete.
  bool has_single = true;
};

/// Copies the frames of the folders `join` (see join_folders). If all frames of the job exist, whole or as strips,
/// joins the strips and writes the videos, job.toml and report.json. Renders nothing. Treats kSingleFolder in the same
/// way. The job is read from the job.toml of `folder`, or else of the first folder of `join`. Throws Error for folders
/// without a render, and for files that cannot be written.
FinishedAnimation finish_animation(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& join,
                                   const Context& context, const RenderObserver& observer = {});

using CompleteFolder = std::function<RenderReport(const RenderParams&)>;

/// Like finish_animation(), but if all frames exist, `complete` writes the remaining files and returns the report.
FinishedAnimation finish_folder(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& join,
                                const CompleteFolder& complete);

}  // namespace lippmann
