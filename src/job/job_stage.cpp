#include "job/job_stage.hpp"

#include <utility>

namespace lippmann {

JobStage::JobStage(const ResolvedJob& job, const ThreadPool& pool, const Context& context)
    : JobStage(load_scene_of(job, context), job, pool) {
  if (!array.warning.empty()) context.warning(array.warning);
}

JobStage::JobStage(JobScene loaded, const ResolvedJob& job, const ThreadPool& pool)
    : JobStage(std::move(loaded), lippmann::place(job, loaded.scene), *job.sampling().integrator, pool) {}

// `loaded` is a reference, so that its scene is moved only after the optics have been placed in it.
JobStage::JobStage(JobScene&& loaded, PlacedJob placed_job, Integrator integrator, const ThreadPool& pool)
    : Stage(std::move(loaded.scene), std::move(placed_job.array), std::move(placed_job.placed), integrator, pool),
      display(std::move(placed_job.display)),
      light(std::move(loaded.notes.light)) {}

void JobStage::place(const ResolvedJob& job) {
  PlacedJob other = lippmann::place(job, scene);
  array = std::move(other.array);
  placed = std::move(other.placed);
  display = std::move(other.display);
}

}  // namespace lippmann
