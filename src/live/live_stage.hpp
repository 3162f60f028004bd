// Keeps a scene ready for rendering while its settings change.
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
  /// `context` must outlive this object. Throws Error.
  LiveStage(const ResolvedJob& job, const Context& context);

  /// Reloads the scene only if the scene, its light or the integrator has changed. On an Error, nothing changes.
  void set(const ResolvedJob& job);

  const ResolvedJob& job() const { return job_; }
  JobStage& stage() { return *stage_; }
  const JobStage& stage() const { return *stage_; }
  const ThreadPool& pool() const { return pool_; }

  /// Renders a frame as `lippmann render` does. Data that frames share are kept as long as only the frame number
  /// changes. Returns nullopt if cancelled. Throws Error if parameters contradict each other.
  std::optional<RenderedFrame> frame(int frame);

  PageFacts facts() const;

 private:
  const Context& context_;
  ThreadPool pool_;
  ResolvedJob job_;
  std::unique_ptr<JobStage> stage_;
  std::unique_ptr<FrameMaker> maker_;
  int last_frame_ = 0;
};

}  // namespace lippmann
