// The stage of a job: its display, its lit scene, and the placed optics.
#pragma once

#include <memory>
#include <string>

#include "frames/frame.hpp"
#include "job/job_scene.hpp"
#include "job/placed_job.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

struct JobStage : Stage {
  std::unique_ptr<const Display> display;  ///< null: the optics come from parameters alone
  std::string light;                       ///< SceneNotes::light

  /// Loads the scene, places the optics and builds the ray-tracing structures. Throws Error.
  JobStage(const ResolvedJob& job, const ThreadPool& pool, const Context& context);
  /// Makes the stage from a loaded scene. The scene keeps its light, whatever environment the job names. Throws Error.
  JobStage(JobScene loaded, const ResolvedJob& job, const ThreadPool& pool);

  /// Replaces the optics by those of a job with the same scene, light and integrator. If it throws Error, nothing has changed.
  void place(const ResolvedJob& job);

 private:
  JobStage(JobScene&& loaded, PlacedJob placed_job, Integrator integrator, const ThreadPool& pool);
};

}  // namespace lippmann
