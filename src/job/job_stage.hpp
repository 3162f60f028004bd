// The stage of a job: its display, its scene in its light, and the optics where the parameters want them.
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
  std::unique_ptr<const Display> display;  ///< none: optics of the parameters alone
  std::string light;                       ///< SceneNotes::light

  /// Loads the scene, places the optics and builds what rays are traced against. Throws Error.
  JobStage(const ResolvedJob& job, const ThreadPool& pool, const Context& context);
  /// The same for a scene that is there already. It keeps its light, whatever environment the job names. Throws Error.
  JobStage(JobScene loaded, const ResolvedJob& job, const ThreadPool& pool);

  /// Places other optics: those of a job with the same scene, light and integrator. Throws Error, and then stays as it was.
  void place(const ResolvedJob& job);

 private:
  JobStage(JobScene&& loaded, PlacedJob placed_job, Integrator integrator, const ThreadPool& pool);
};

}  // namespace lippmann
