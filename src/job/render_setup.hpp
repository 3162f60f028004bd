// The set-up of one run of a job before its first frame. Invalid jobs are refused here, before anything is written.
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

/// The objects that one run of a job needs. Not movable, because its members refer to each other.
struct RenderSetup {
 private:
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();

 public:
  ResolvedJob job;  ///< the job, with the output folder filled in
  const FrameParams frame_settings;
  const RunParams run;
  const ThreadPool pool;
  JobStage stage;
  const RunParts parts;
  const FrameLayout layout;
  MemoryPlan memory;                ///< the plan that makes frames fit into the available memory
  double join_bytes = 0.0;          ///< estimated memory for joining a frame from strips; 0: no frame is joined
  std::optional<double> crosstalk;  ///< crosstalk to correct, as a sigma in the optics' pixels or views; nullopt: none
  FormatOptions writing;            ///< options of the light-field format
  std::vector<VideoFile> videos;    ///< videos of all frames; empty if other runs render some of the frames
  std::string fingerprint;          ///< fingerprint of the job (job_fingerprint.hpp)
  std::filesystem::path folder;     ///< output folder
  /// The default folder if it holds another render, so that `folder` is a different one; otherwise empty.
  std::filesystem::path crowded_folder;

  /// Loads the scene unless `loaded` is given. Throws Error for jobs that cannot be rendered, and for folders that hold
  /// anything but this render.
  RenderSetup(const ResolvedJob& wanted, const RunParams& run, const Context& context,
              std::optional<JobScene> loaded = std::nullopt);
  RenderSetup(const RenderSetup&) = delete;
  RenderSetup& operator=(const RenderSetup&) = delete;

  /// Returns the seconds since the set-up began.
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count(); }

  const Optics& optics() const { return stage.placed.optics; }

  /// Returns whether finished frames of earlier runs are kept. False if a video needs codes that the pictures do not store
  /// exactly.
  bool keeps_frames() const;

  /// Returns whether the run leaves its frames in strips, because other runs render some of the strips or because frames are
  /// joined after all ranks have ended.
  bool leaves_strips() const { return job.is_in_strips() && (run.units || run.parts || run.ranks); }

  /// Returns the plan of the run. `kept` is the number of parts that exist already.
  RenderPlan plan(int kept) const;

  /// Returns a report without frames.
  RenderReport report() const;
};

}  // namespace lippmann
