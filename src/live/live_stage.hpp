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
#include "live/scene_file_state.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

class LiveStage {
 public:
  /// `context` must outlive this object. Throws Error.
  LiveStage(const ResolvedJob& job, const Context& context);

  /// Reloads the scene only if the scene, its file, its light or the integrator has changed. On an Error, nothing changes.
  void set(const ResolvedJob& job);

  /// Returns whether the scene's file has changed since it was last read, and has not changed between the last two calls. A
  /// file that is being written is therefore not read.
  bool has_new_file();

  const ResolvedJob& job() const { return job_; }
  JobStage& stage() { return *stage_; }
  const JobStage& stage() const { return *stage_; }
  const ThreadPool& pool() const { return pool_; }

  /// Renders a frame as `lippmann render` does. Data that frames share are kept as long as only the frame number
  /// changes. Returns nullopt if cancelled. Throws Error if parameters contradict each other.
  std::optional<RenderedFrame> frame(int frame);

  PageFacts facts() const;

 private:
  std::unique_ptr<JobStage> load(const ResolvedJob& job);

  const Context& context_;
  ThreadPool pool_;
  ResolvedJob job_;
  SceneFileState loaded_, tried_, seen_;  ///< of the scene that is in use; at the last attempt to load it; at the last look
  std::unique_ptr<JobStage> stage_;
  std::unique_ptr<FrameMaker> maker_;
  int last_frame_ = 0;
};

}  // namespace lippmann
