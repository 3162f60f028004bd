// Writes job.toml, which repeats the render in a folder, and report.json, which holds its figures.
#pragma once

#include <vector>

#include "folder/render_folder.hpp"
#include "job/report.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Writes job.toml for the frames, videos and companions (FolderJournal::companions) of all runs in the folder. Keeps a
/// job.toml that the user has edited; a resumed run replaces a damaged one. Call this after the run has begun.
void write_job_of_folder(const ResolvedJob& job, const std::vector<int>& frames, int frame_count, RenderFolder& folder,
                         const Context& context);

/// Writes a first report, so that the optics of the frames can be read during the render and after a crash. Does
/// nothing if the folder already has a report of this render.
void begin_report(const RenderReport& run, RenderFolder& folder);

/// Writes and returns the report of all frames in the journal, with the totals of all finished runs. Call this after
/// RenderFolder has recorded the end of the run.
RenderReport write_report(const RenderReport& run, RenderFolder& folder);

}  // namespace lippmann
