#include "live/live_render.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "job/animation.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

double now_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

LiveRender::~LiveRender() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

void LiveRender::start(const ResolvedJob& job, std::function<void()> ended) {
  {
    const std::lock_guard lock(mutex_);
    if (state_ == "running") throw Error("render", "another render is running", "cancel the running render first");
    state_ = "running", folder_.clear(), error_.clear();
    frames_ = done_ = 0, share_ = 0.0, started_ = now_seconds();
  }
  // The lock must not be held here, because the previous thread may need it in `ended`.
  if (thread_.joinable()) thread_.join();
  context_.cancelled = false;
  thread_ = std::thread([this, job, ended = std::move(ended)] {
    run(job);
    ended();
  });
}

void LiveRender::cancel() { context_.cancelled = true; }

bool LiveRender::is_running() const {
  const std::lock_guard lock(mutex_);
  return state_ == "running";
}

std::optional<std::filesystem::path> LiveRender::finished_folder() const {
  const std::lock_guard lock(mutex_);
  return state_ == "finished" ? std::optional<std::filesystem::path>(folder_) : std::nullopt;
}

void LiveRender::run(const ResolvedJob& job) {
  RenderObserver observer;
  observer.planned = [this](const RenderPlan& plan) {
    const std::lock_guard lock(mutex_);
    frames_ = static_cast<int>(plan.frames.size()), done_ = plan.kept, folder_ = plan.folder.string();
    started_ = now_seconds();
  };
  observer.traced = [this](const FrameReport&) {
    const std::lock_guard lock(mutex_);
    ++done_, share_ = 0.0;
  };
  context_.frame_progress = [this](double share) {
    const std::lock_guard lock(mutex_);
    share_ = share;
  };
  try {
    const RenderReport report = render_animation(job, context_, observer);
    const std::lock_guard lock(mutex_);
    state_ = report.interrupted ? "stopped" : "finished";
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    state_ = "failed", error_ = error.what();
  }
}

nlohmann::ordered_json LiveRender::json() const {
  const std::lock_guard lock(mutex_);
  if (state_.empty()) return nullptr;
  const double share = frames_ > 0 ? std::min((done_ + share_) / frames_, 1.0) : 0.0;
  nlohmann::ordered_json json{{"state", state_},         {"frames", frames_}, {"done", done_},  {"share", share},
                              {"seconds_left", nullptr}, {"folder", folder_}, {"error", error_}};
  if (state_ == "running" && share > 0.02) json["seconds_left"] = (now_seconds() - started_) * (1.0 - share) / share;
  return json;
}

}  // namespace lippmann
