// Renders an animation into a folder. While a frame is traced, earlier frames are encoded and written.
#pragma once

#include "job/render_plan.hpp"
#include "job/render_setup.hpp"
#include "job/report.hpp"
#include "job/resolved_job.hpp"
#include "job/run_params.hpp"
#include "job/run_progress.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Renders the frames of a job and writes the pictures, the videos, job.toml and report.json into output_folder(). Pictures and
/// videos have the same bytes for any number of threads, and whether or not the render was interrupted and resumed.
///
/// If frames are rendered in strips (RenderParams::strips), a run that renders only some units, or that several processes
/// (RunParams::ranks) share, leaves the strips in the folder. A run of the whole job, or a run with RunParams::only_finished,
/// joins the strips to frames.
///
/// Stops soon after context.cancelled is set. Finished frames are then kept, the current frame and unfinished videos leave no
/// files, and report.json has `interrupted` set. Throws Error for jobs that cannot be rendered, before any file is made. Throws
/// Error for files that cannot be written; --resume then keeps the frames that are finished.
RenderReport render_animation(const ResolvedJob& job, const Context& context, const RenderObserver& observer = {},
                              const RunParams& run = {});

/// Renders a job that is already set up.
RenderReport render_animation(RenderSetup& setup, const Context& context, const RenderObserver& observer = {});

}  // namespace lippmann
