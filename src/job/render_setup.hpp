// Sets up one run of a job. Invalid jobs are rejected here, before anything is written.
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

/// Not movable, because its members refer to each other.
struct RenderSetup {
 private:
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();

 public:
  ResolvedJob job;  ///< with its output folder filled in
  const FrameParams frame_settings;
  const RunParams run;
  const ThreadPool pool;
  JobStage stage;
  const RunParts parts;
  const FrameLayout layout;
  MemoryPlan memory;  ///< how frames fit into the available memory
  /// Estimated memory for joining a frame from strips; 0: no frame is joined.
  double join_bytes = 0.0;
  /// Crosstalk to correct: the standard deviation of the Gaussian blur (optics/crosstalk.hpp), in pixels, or in views
  /// for a quilt.
  std::optional<double> crosstalk;
  FormatOptions writing;
  /// Videos that this run writes; empty if other runs render some of the frames.
  std::vector<VideoFile> videos;
  std::string fingerprint;
  std::filesystem::path folder;
  /// Default output folder, if it holds another render and `folder` is therefore a different folder; otherwise empty.
  std::filesystem::path crowded_folder;

  /// Loads the scene unless `loaded` is given. Throws Error if the job cannot be rendered, or if the folder holds
  /// anything except this render.
  RenderSetup(const ResolvedJob& wanted, const RunParams& run, const Context& context,
              std::optional<JobScene> loaded = std::nullopt);
  RenderSetup(const RenderSetup&) = delete;
  RenderSetup& operator=(const RenderSetup&) = delete;

  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count(); }

  const Optics& optics() const { return stage.placed.optics; }

  /// Frames of earlier runs are not kept if the job makes videos and its pictures are not 8-bit PNG files, because
  /// videos need the exact 8-bit values.
  bool keeps_frames() const;

  /// A run leaves its frames in strips if other runs or ranks render some of them. Ranks join the strips at the end.
  bool leaves_strips() const { return job.is_in_strips() && (run.units || run.parts || run.ranks); }

  /// `kept`: frames or strips that exist already.
  RenderPlan plan(int kept) const;

  /// Returns a report without frames.
  RenderReport report() const;
};

}  // namespace lippmann
