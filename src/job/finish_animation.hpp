// The end of a job that was rendered in parts: what has come of it, and the files that only the whole can have.
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
  FolderCheck check;           ///< the folder as it was before it was finished
  std::vector<int> to_render;  ///< frames that are not finished, or not as they were written, and cannot be joined from strips
  std::optional<RenderReport> report;  ///< the whole folder's; none where frames are to be rendered
  bool has_single = true;              ///< false: the job asks for a render in kSingleFolder too, which is not complete
};

/// Takes over the frames of the folders `join` (join_folders), reads all files of the folder, and if every frame that the job
/// asks for is there, or all of its strips are, joins strips and writes its videos, job.toml and report.json. Renders nothing.
/// A render in kSingleFolder that the job asks for is finished like it. The job is the folder's job.toml, or else that of the
/// first folder to be joined. Throws Error for folders without a render, and for what cannot be written.
FinishedAnimation finish_animation(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& join,
                                   const Context& context, const RenderObserver& observer = {});

/// The same with whatever writes the videos and the two files of a folder in which all frames are.
using CompleteFolder = std::function<RenderReport(const RenderParams&)>;
FinishedAnimation finish_folder(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& join,
                                const CompleteFolder& complete);

}  // namespace lippmann
