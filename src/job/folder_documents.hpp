// Writes the two files that describe the whole render of a folder: job.toml repeats it, and report.json holds its figures.
#pragma once

#include <vector>

#include "folder/render_folder.hpp"
#include "job/report.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Writes a job file for all frames, videos and companions (FolderJournal::companions) of this run and of all other runs in the
/// folder. A job.toml that the user edited or wrote is kept; a resumed run replaces a damaged one. Call after the run has
/// begun.
void write_job_of_folder(const ResolvedJob& job, const std::vector<int>& frames, int frame_count, RenderFolder& folder,
                         const Context& context);

/// Writes a first report when a run begins, unless the folder already has a report of this render. Readers find the optics of
/// the frames in it, during the render and after a crash.
void begin_report(const RenderReport& run, RenderFolder& folder);

/// Writes the report of `run` with all frames of the folder's journal and the totals of all finished runs. Call after the run's
/// end is recorded. Returns the report.
RenderReport write_report(const RenderReport& run, RenderFolder& folder);

}  // namespace lippmann
