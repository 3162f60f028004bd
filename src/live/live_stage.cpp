#include "live/live_stage.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <variant>

#include "job/job_file.hpp"
#include "job/reuse_params.hpp"
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

/// One frame alone: pixels that could be copied from others are traced, to the same bits and without a search for them.
FrameParams params_of_one_frame(const RenderParams& params) {
  FrameParams made_as = frame_params(params);
  if (std::holds_alternative<CopySettled>(resolved_reuse(made_as))) made_as.reuse = TraceAll{};
  return made_as;
}

}  // namespace

LiveStage::LiveStage(const RenderParams& params, const Context& context)
    : context_(context),
      pool_(params.threads > 0 ? params.threads : resolved_threads(context)),
      params_(params),
      stage_(std::make_unique<JobStage>(params, pool_, context)) {}

void LiveStage::set(const RenderParams& params) {
  if (job_text(params, {}) == job_text(params_, {})) return;
  maker_.reset();
  if (scene_key(params) == scene_key(params_))
    stage_->place(params);
  else
    stage_ = std::make_unique<JobStage>(params, pool_, context_);
  params_ = params;
}

std::optional<RenderedFrame> LiveStage::frame(int frame) {
  if (!maker_ || frame <= last_frame_) {
    const FrameParams made_as = params_of_one_frame(params_);
    check(made_as, stage_->placed.optics);
    maker_.reset();
    maker_ = params_.scene.name == kTestPattern ? make_pattern_frames(*stage_, pool_)
                                                : make_frame_maker(*stage_, made_as, pool_, context_);
  }
  last_frame_ = frame;
  RenderedFrame made = maker_->make(frame);
  if (!context_.cancelled) return made;
  maker_.reset();  // what it keeps is unfinished, too
  return std::nullopt;
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
