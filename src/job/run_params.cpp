#include "job/run_params.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "frames/frame_maker.hpp"
#include "job/job_folder.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

std::vector<int> parts_of_run(const RunParams& run, const std::vector<int>& of_job, int segment, int strips) {
  if (run.parts) return *run.parts;
  const std::vector<int> of_units = run.units ? frames_of(*run.units, of_job, segment) : of_job;
  if (!run.only_frames) return of_units;
  const std::vector<int> wanted = parts_of(frames_of(*run.only_frames), strips);
  std::vector<int> both;
  std::set_intersection(of_units.begin(), of_units.end(), wanted.begin(), wanted.end(), std::back_inserter(both));
  if (both.empty() && !of_units.empty())
    throw usage_error("only-frames", fmt::format("{} selects no frame of this render", write_frames(*run.only_frames)),
                      fmt::format("frames among {}", write_frames(ranges_of(frames_of_parts(of_units, strips)))));
  return both;
}

}  // namespace

RunParts::RunParts(const ResolvedJob& job, const FrameParams& frame_settings, const Timeline& timeline, const RunParams& run)
    : strips(job.params().strips),
      segment(segment_of(job, frame_settings)),
      of_job(frames_of_job(job.params(), timeline)),
      parts(parts_of_run(run, parts_of(of_job, strips), segment, strips)),
      frames(frames_of_parts(parts, strips)) {}

int segment_of(const ResolvedJob& job, const FrameParams& frame_settings) {
  return job.is_in_strips() ? 1 : frames_per_segment(frame_settings);
}

}  // namespace lippmann
