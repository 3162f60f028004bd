#include "live/live_stage.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "job/job_file.hpp"
#include "job/test_pattern.hpp"

namespace lippmann {
namespace {

/// All that a scene, its light and its tables depend on.
std::string scene_key(const RenderParams& params) {
  RenderParams key;
  key.scene = params.scene;
  key.scene.view = {};
  key.sampling.integrator = params.sampling.integrator;
  return job_text(key, {});
}

}  // namespace

LiveStage::LiveStage(const RenderParams& params, const Context& context)
    : context_(context),
      pool_(params.threads > 0 ? params.threads : resolved_threads(context)),
      params_(params),
      stage_(std::make_unique<JobStage>(params, pool_, context)) {}

void LiveStage::set(const RenderParams& params) {
  if (scene_key(params) == scene_key(params_))
    stage_->place(params);
  else
    stage_ = std::make_unique<JobStage>(params, pool_, context_);
  params_ = params;
}

PageFacts LiveStage::facts() const {
  PageFacts facts = page_facts(stage_->placed.optics);
  facts.title = std::filesystem::path(params_.scene.name).filename().string();
  facts.has_depth = params_.scene.name != kTestPattern && facts.grid.count() > 1;
  const Timeline& timeline = stage_->scene.timeline;
  facts.frames_per_second = params_.scene.fps > 0.0 ? params_.scene.fps : timeline.frames_per_second;
  for (int frame = 0; frame < timeline.frame_count; ++frame) facts.frames.push_back({fmt::format("{:04}", frame), {}});
  return facts;
}

}  // namespace lippmann
