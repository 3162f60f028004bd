// The stage of a scene whose settings change while it is looked at: only what a change concerns is made anew.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "frames/frame_maker.hpp"
#include "job/job_stage.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/core/parallel.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

class LiveStage {
 public:
  /// Loads the scene. `context` outlives it. Throws Error.
  LiveStage(const ResolvedJob& job, const Context& context);

  /// The array is fitted anew and optics are made; the scene is loaded again where it, its light or its integrator is another.
  /// Throws Error, and then stays as it was.
  void set(const ResolvedJob& job);

  const ResolvedJob& job() const { return job_; }
  JobStage& stage() { return *stage_; }
  const JobStage& stage() const { return *stage_; }
  const ThreadPool& pool() const { return pool_; }

  /// A frame as `lippmann render` makes it. What frames share is kept while nothing but the frame changes, and best where they
  /// are asked for in ascending order. None where the context was cancelled meanwhile. Throws Error for parameters that
  /// contradict each other.
  std::optional<RenderedFrame> frame(int frame);

  /// What a page needs to know of a light field behind its optics, with the scene's title, frames and depth.
  PageFacts facts() const;

 private:
  const Context& context_;
  ThreadPool pool_;
  ResolvedJob job_;
  std::unique_ptr<JobStage> stage_;
  std::unique_ptr<FrameMaker> maker_;  ///< of this job; null: there is none yet
  int last_frame_ = 0;                 ///< that it made
};

}  // namespace lippmann
