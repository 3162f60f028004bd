// Chooses and clears the folder of a render. A folder holds one render, whose files its journal records
// (folder/journal.hpp). Files of another render are removed only with `force` (--force). `job` is job_fingerprint().
// Files that are named like frames but are not in the journal are called foreign.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

/// Returns the first of `wanted`, wanted-2, wanted-3, ... that holds no other render, no running render and no foreign
/// files.
std::filesystem::path free_folder(const std::filesystem::path& wanted, const std::string& job);

/// Throws Error if `folder` holds another render, a running job, a damaged journal or foreign files. Also throws Error if one
/// of `videos` exists, unless this render made the video and the video shows only frames in `frames`. Changes nothing.
/// `differences` returns the parameters in which a job file differs from this job, for the message.
using JobDifferences = std::function<std::vector<std::string>(const std::filesystem::path& job_file)>;
void require_free_folder(const std::filesystem::path& folder, const std::string& job, const JobDifferences& differences,
                         const std::vector<int>& frames, const std::vector<std::string>& videos);

struct NewRender {
  std::string job;
  std::vector<int> frames;
  bool force = false;
  /// Journal file of this run, which is not removed; empty if the run has not begun.
  std::filesystem::path own = {};
};

/// Removes the files of runs of other jobs that have finished no frame or strip. With `force`, also removes the files of
/// another render, and foreign files of frames. Does not follow symbolic links. Warns about foreign files that remain. Throws
/// Error if a file cannot be removed, if a run of another job is active, or if the folder holds another render and `force` is
/// false.
void clear_folder(const std::filesystem::path& folder, const NewRender& render, const Context& context);

/// For outputs other than renders: throws Error if `out` is a finished file of a render, or the folder of a render.
void require_no_render(const std::filesystem::path& out);

}  // namespace lippmann
