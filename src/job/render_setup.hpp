// Everything that one run of a job needs before it makes its first frame. What can be refused, is refused here; nothing is
// written yet.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "folder/frame_layout.hpp"
#include "folder/frame_sink.hpp"
#include "job/job_stage.hpp"
#include "job/memory_plan.hpp"
#include "job/render_plan.hpp"
#include "job/report.hpp"
#include "job/resolved_job.hpp"
#include "job/run_params.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Stays where it was made: its members refer to each other.
struct RenderSetup {
 private:
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();

 public:
  ResolvedJob job;  ///< with the folder that is written to
  const FrameParams made_as;
  const RunParams run;
  const ThreadPool pool;
  JobStage stage;
  const RunParts parts;
  const FrameLayout layout;
  MemoryPlan memory;                     ///< how frames are made in the memory that there is
  double join_bytes = 0.0;               ///< memory for joining a frame from strips; 0: none is joined
  std::optional<double> crosstalk;       ///< to be undone: a sigma in the optics' pixels or views
  FormatOptions writing;                 ///< what the format of light fields is told
  std::vector<VideoFile> videos;         ///< of all frames; none where other runs render the rest
  std::string fingerprint;               ///< of the job (job_fingerprint.hpp)
  std::filesystem::path folder;          ///< where the files go
  std::filesystem::path crowded_folder;  ///< the usual one, where it holds another render; else empty

  /// Loads the scene, unless it is given. Throws Error for jobs that cannot be rendered, and for folders that hold something
  /// else.
  RenderSetup(const ResolvedJob& wanted, const RunParams& run, const Context& context,
              std::optional<JobScene> loaded = std::nullopt);
  RenderSetup(const RenderSetup&) = delete;
  RenderSetup& operator=(const RenderSetup&) = delete;

  /// Since it was begun.
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count(); }

  const Optics& optics() const { return stage.placed.optics; }

  /// Whether frames that are finished are kept; not where a video wants codes that the pictures do not hold to the bit.
  bool keeps_frames() const;

  /// Whether the run makes strips alone: others make the rest, or frames are joined once all ranks are done.
  bool leaves_strips() const { return job.is_in_strips() && (run.units || run.parts || run.ranks); }

  /// `kept`: how many of its parts are there already.
  RenderPlan plan(int kept) const;

  /// A report without frames.
  RenderReport report() const;
};

}  // namespace lippmann
