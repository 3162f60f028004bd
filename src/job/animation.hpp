// Renders an animation into a folder. Each frame is traced while the ones before it are encoded and written.
#pragma once

#include "job/render_plan.hpp"
#include "job/render_setup.hpp"
#include "job/report.hpp"
#include "job/resolved_job.hpp"
#include "job/run_params.hpp"
#include "job/run_progress.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Writes the pictures, the videos, job.toml and report.json into output_folder(). The pictures and videos are the same, byte
/// for byte, for any number of threads, and whether or not the render was interrupted and resumed.
///
/// If frames are rendered in strips (RenderParams::strips), runs of units and ranks leave the strips in the folder. Runs of the
/// whole job, and runs with only_finished, join the strips to frames.
///
/// Stops soon after context.cancelled is set. Finished frames are kept, the current frame and unfinished videos leave no files,
/// and report.json has `interrupted` set. Throws Error for jobs that cannot be rendered (before any file is made) and for files
/// that cannot be written; the frames finished by then are kept for --resume.
RenderReport render_animation(const ResolvedJob& job, const Context& context, const RenderObserver& observer = {},
                              const RunParams& run = {});

/// Renders a job that is already set up.
RenderReport render_animation(RenderSetup& setup, const Context& context, const RenderObserver& observer = {});

}  // namespace lippmann
