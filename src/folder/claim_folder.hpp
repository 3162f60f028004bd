// Chooses and clears the folder of a render. A folder holds one render. Files of another render are neither overwritten nor
// silently kept. With `force` (--force) they are removed.
//
// `job` is job_fingerprint(). The files of a render are those in the folder's journal (folder/journal.hpp). Files that are
// named like frames but are not in the journal are foreign.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

/// Returns the first of `wanted`, wanted-2, wanted-3, ... that holds no other render, no running render and no foreign files.
std::filesystem::path free_folder(const std::filesystem::path& wanted, const std::string& job);

/// Throws Error if `folder` holds another render, a running job, a damaged journal or foreign files. Also throws if one of the
/// `videos` exists and the folder's render did not write it, or if it shows frames of that render that are not among `frames`.
/// Changes nothing. `differences` returns the names of the parameters that differ from another render's job file, for the
/// message.
using JobDifferences = std::function<std::vector<std::string>(const std::filesystem::path& job_file)>;
void require_free_folder(const std::filesystem::path& folder, const std::string& job, const JobDifferences& differences,
                         const std::vector<int>& frames, const std::vector<std::string>& videos);

/// The render for which clear_folder() clears the folder.
struct NewRender {
  std::string job;
  std::vector<int> frames;
  bool force = false;
  std::filesystem::path own = {};  ///< journal file of this run, which is not removed; empty: the run has not begun
};

/// Clears an existing folder. Removes the leftovers of other jobs' runs that finished nothing. With `force`, also removes the
/// files in another render's journal and foreign files of frames. Does not follow symbolic links. Warns about foreign files
/// that remain. Throws Error for a file that cannot be removed, if a run of another job is active, and without `force` for
/// another render.
void clear_folder(const std::filesystem::path& folder, const NewRender& render, const Context& context);

/// Throws Error if `out`, a destination outside of renders, is a finished file of a render or a render's folder.
void require_no_render(const std::filesystem::path& out);

}  // namespace lippmann
