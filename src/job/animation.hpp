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

/// Renders the frames of a job and writes the pictures, the videos, job.toml and report.json into output_folder().
/// Pictures and videos have the same bytes for any number of threads, and after a resumed render. A run of only some
/// strips, or by several ranks, leaves the strips in the folder (RenderParams::strips); a run of the whole job, or one
/// with RunParams::only_finished, joins them to frames. After context.cancelled is set, finished frames are kept and
/// report.json has `interrupted` set. Throws Error for jobs that cannot be rendered, before any file is made, and for
/// files that cannot be written.
RenderReport render_animation(const ResolvedJob& job, const Context& context, const RenderObserver& observer = {},
                              const RunParams& run = {});

RenderReport render_animation(RenderSetup& setup, const Context& context, const RenderObserver& observer = {});

}  // namespace lippmann
