#include "live/live_stage.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <variant>

#include "job/job_file.hpp"
#include "job/reuse_params.hpp"
#include "job/test_pattern.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// Returns a text of all parameters that affect loading. If this text changes, the scene must be loaded again.
std::string scene_key(const ResolvedJob& job) {
  RenderParams key;
  key.scene = job.scene();
  key.scene.view = {};
  key.sampling.integrator = job.sampling().integrator;
  return job_text(key, {});
}

/// Returns parameters that trace all pixels instead of copying unchanged pixels from other frames. The image is the same, but
/// finding unchanged pixels takes time.
FrameParams params_of_one_frame(const ResolvedJob& job) {
  FrameParams frame_settings = frame_params(job);
  if (std::holds_alternative<CopySettled>(resolved_reuse(frame_settings))) frame_settings.reuse = TraceAll{};
  return frame_settings;
}

}  // namespace

LiveStage::LiveStage(const ResolvedJob& job, const Context& context)
    : context_(context), pool_(job.threads(context)), job_(job), stage_(load(job)) {}

void LiveStage::set(const ResolvedJob& job) {
  const bool is_other_scene = scene_key(job) != scene_key(job_) || scene_file_state(job.scene().name) != loaded_;
  if (!is_other_scene && job_text(job.params(), {}) == job_text(job_.params(), {})) return;
  maker_.reset();
  if (is_other_scene)
    stage_ = load(job);
  else
    stage_->place(job);
  job_ = job;
}

bool LiveStage::has_new_file() {
  const SceneFileState now = scene_file_state(job_.scene().name);
  return std::exchange(seen_, now) == now && now != tried_;
}

/// Loads the scene again if its file changes meanwhile, so that the result never mixes two states of the file.
std::unique_ptr<JobStage> LiveStage::load(const ResolvedJob& job) {
  constexpr int kTries = 5;
  const std::string& name = job.scene().name;
  for (int i = 0; i < kTries; ++i) {
    tried_ = scene_file_state(name);
    auto stage = std::make_unique<JobStage>(job, pool_, context_);
    if (scene_file_state(name) != tried_) continue;
    loaded_ = tried_;
    return stage;
  }
  throw Error(name, "changes while it is read", "a file that no program is writing");
}

std::optional<RenderedFrame> LiveStage::frame(int frame) {
  if (!maker_ || frame <= last_frame_) {
    const FrameParams frame_settings = params_of_one_frame(job_);
    check(frame_settings, stage_->placed.optics);
    maker_.reset();
    maker_ = job_.is_test_pattern() ? make_pattern_frames(*stage_, pool_)
                                    : make_frame_maker(*stage_, frame_settings, pool_, context_);
  }
  last_frame_ = frame;
  RenderedFrame made = maker_->make(frame);
  if (!context_.cancelled) return made;
  // The maker may hold data of the unfinished frame.
  maker_.reset();
  return std::nullopt;
}

PageFacts LiveStage::facts() const {
  PageFacts facts = page_facts(stage_->placed.optics);
  facts.title = std::filesystem::path(job_.scene().name).filename().string();
  facts.has_depth = !job_.is_test_pattern() && facts.grid.count() > 1;
  const Timeline& timeline = stage_->scene.timeline;
  facts.frames_per_second = job_.frames_per_second(timeline);
  for (int frame = 0; frame < timeline.frame_count; ++frame) facts.frames.push_back({fmt::format("{:04}", frame), {}});
  return facts;
}

}  // namespace lippmann
