// Chooses and clears the folder of a render. A folder holds one render. Files of another render are neither overwritten nor
// silently kept. With `force` (--force) they are removed.
//
// `job` is job_fingerprint(). The files of a render are those that the folder's journal records (folder/journal.hpp). Files
// that are named like frames but are not recorded in the journal are called foreign.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

/// Returns the first of `wanted`, wanted-2, wanted-3, ... that holds no other render, no running render and no foreign files.
std::filesystem::path free_folder(const std::filesystem::path& wanted, const std::string& job);

/// Throws Error if `folder` holds another render, a running job, a damaged journal or foreign files. Also throws if one of
/// `videos` exists and the folder's render did not write it, or if an existing video shows frames that are not in `frames`.
/// Changes nothing. `differences` returns the names of the parameters in which a job file differs from this job, for the
/// message.
using JobDifferences = std::function<std::vector<std::string>(const std::filesystem::path& job_file)>;
void require_free_folder(const std::filesystem::path& folder, const std::string& job, const JobDifferences& differences,
                         const std::vector<int>& frames, const std::vector<std::string>& videos);

struct NewRender {
  std::string job;
  std::vector<int> frames;
  bool force = false;
  /// Journal file of this run, which is not removed. Empty if the run has not begun.
  std::filesystem::path own = {};
};

/// Clears an existing folder. Removes the files of other jobs whose runs finished nothing. With `force`, also removes the files
/// of another render, and foreign files of frames. Does not follow symbolic links. Warns about foreign files that remain.
/// Throws Error if a file cannot be removed, if a run of another job is active, or if the folder holds another render and
/// `force` is false.
void clear_folder(const std::filesystem::path& folder, const NewRender& render, const Context& context);

/// Throws Error if `out` is a finished file of a render, or the folder of a render. For outputs other than renders.
void require_no_render(const std::filesystem::path& out);

}  // namespace lippmann
