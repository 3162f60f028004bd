// The two files of a folder that speak of all of its render, however many runs have worked at it: job.toml renders the same
// again, report.json says how it went.
#pragma once

#include <vector>

#include "folder/render_folder.hpp"
#include "job/report.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Writes a job file that renders all frames that this run and those before and beside it have been asked for, with the videos,
/// and with the folders beside them (FolderJournal::companions). A job.toml that no run has written, or that was edited, stays;
/// resuming writes a damaged one again. The run has begun.
void write_job_of_folder(const ResolvedJob& job, const std::vector<int>& frames, int frame_count, RenderFolder& folder,
                         const Context& context);

/// Writes a report as soon as a run has begun, unless one of this render is there: whoever looks at the folder meanwhile, or
/// after a crash, learns from it which optics the frames are of.
void begin_report(const RenderReport& run, RenderFolder& folder);

/// Writes what `run` reports with all frames that the folder's journal knows, and what all runs that have ended took. The run's
/// own end is recorded. Returns what it wrote.
RenderReport write_report(const RenderReport& run, RenderFolder& folder);

}  // namespace lippmann
