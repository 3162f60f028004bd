// Which folder a render goes into, and what becomes of what lies there: one folder holds one render. What belongs to another is
// never overwritten, and never kept beside the new one unsaid, unless the caller says so (--force).
//
// `job`: job_fingerprint(). Files of a render are those that the folder's journal names (folder/journal.hpp); files that are
// named as those of frames and that no journal names are foreign.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

/// `wanted`, or the first of wanted-2, wanted-3, ... that holds no other render, in which none goes on, and that holds no
/// foreign files.
std::filesystem::path free_folder(const std::filesystem::path& wanted, const std::string& job);

/// Throws Error if `folder` holds another render, a run of another job goes on there, its journal is damaged, or it holds
/// foreign files; if one of the `videos` is there
/// and the render in the folder has not written it, or it shows frames of that render that are not among `frames`. Changes
/// nothing. `differences`: the names of what another render, whose job file is given, has set differently, for the message.
using JobDifferences = std::function<std::vector<std::string>(const std::filesystem::path& job_file)>;
void require_free_folder(const std::filesystem::path& folder, const std::string& job, const JobDifferences& differences,
                         const std::vector<int>& frames, const std::vector<std::string>& videos);

/// The render that clear_folder() makes room for.
struct NewRender {
  std::string job;
  std::vector<int> frames;
  bool force = false;
  std::filesystem::path own = {};  ///< the file of the journal that the run has begun, which stays; empty: it has not yet
};

/// Makes room in a folder that exists: removes what runs of other jobs that finished nothing have left, and with `force` the
/// files of another render, each by its name in the journal, and foreign files of the frames. Folders that are symbolic links
/// are not gone into. Says in a warning which foreign files stay. Throws Error for a file that cannot be removed; if a run of
/// another job goes on there; and without `force` for another render.
void clear_folder(const std::filesystem::path& folder, const NewRender& render, const Context& context);

/// Throws Error if `out`, a file or a folder of frames that something other than a render is to write, is a finished file of a
/// render or the folder of one.
void require_no_render(const std::filesystem::path& out);

}  // namespace lippmann
