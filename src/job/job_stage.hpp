// The stage of a job: its display, its lit scene and its placed optics.
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
  std::unique_ptr<const Display> display;  ///< null if the job has no display
  std::string light;                       ///< one sentence on the light (SceneNotes::light)

  /// Loads the scene, places the optics and builds the acceleration structures. Throws Error.
  JobStage(const ResolvedJob& job, const ThreadPool& pool, const Context& context);
  /// The scene keeps its light, even if the job names another environment. Throws Error.
  JobStage(JobScene loaded, const ResolvedJob& job, const ThreadPool& pool);

  /// Replaces the optics by those of `job`, which must have the same scene, light and integrator. If place() throws Error, the
  /// stage is unchanged.
  void place(const ResolvedJob& job);

 private:
  JobStage(JobScene&& loaded, PlacedJob placed_job, Integrator integrator, const ThreadPool& pool);
};

}  // namespace lippmann
