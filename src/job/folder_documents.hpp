// Writes the two files that describe the whole render in a folder. job.toml holds the parameters that repeat the render.
// report.json holds its figures.
#pragma once

#include <vector>

#include "folder/render_folder.hpp"
#include "job/report.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Writes job.toml for the frames, videos and companions (FolderJournal::companions) of this run and of all other runs in the
/// folder. Keeps a job.toml that the user has edited or written. A resumed run replaces a damaged job.toml. Call this after the
/// run has begun.
void write_job_of_folder(const ResolvedJob& job, const std::vector<int>& frames, int frame_count, RenderFolder& folder,
                         const Context& context);

/// Writes a first report at the beginning of a run, so that the optics of the frames can be read during the render and after a
/// crash. Does nothing if the folder already has a report of this render.
void begin_report(const RenderReport& run, RenderFolder& folder);

/// Writes the report of `run` with all frames of the folder's journal and the totals of all finished runs. Call this after
/// RenderFolder has recorded the end of the run. Returns the report.
RenderReport write_report(const RenderReport& run, RenderFolder& folder);

}  // namespace lippmann
