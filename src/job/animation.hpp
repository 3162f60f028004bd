// Renders an animation into a folder: frames in order, each traced while the ones before it are encoded and written.
#pragma once

#include "job/render_plan.hpp"
#include "job/render_setup.hpp"
#include "job/report.hpp"
#include "job/resolved_job.hpp"
#include "job/run_params.hpp"
#include "job/run_progress.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Writes into output_folder(): the pictures, the videos, job.toml and report.json. The same pictures and videos, byte for
/// byte, for any number of threads, and whether or not the render was interrupted and resumed.
///
/// Where frames are rendered in strips (RenderParams::strips), runs of units, and of ranks, leave strips in the folder; whoever
/// renders whole frames, or has all of a unit's made (only_finished), joins them.
///
/// When context.cancelled is set, it stops at the next chance: finished frames stay, the frame under way and videos leave
/// nothing, report.json says `interrupted`. Throws Error for jobs that cannot be rendered (before any file is made) and for
/// files that cannot be written; the frames finished until then stay, for --resume.
RenderReport render_animation(const ResolvedJob& job, const Context& context, const RenderObserver& observer = {},
                              const RunParams& run = {});

/// The same of a job that is set up.
RenderReport render_animation(RenderSetup& setup, const Context& context, const RenderObserver& observer = {});

}  // namespace lippmann
