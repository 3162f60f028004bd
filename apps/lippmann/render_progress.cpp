#include "apps/lippmann/render_progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/lippmann/print.hpp"
#include "core/json_text.hpp"
#include "job/job_stage.hpp"
#include "job/size_estimate.hpp"
#include "stage/depth_budget.hpp"

namespace lippmann::app {
namespace {

ProgressStyle style_of(RenderProgressKind kind) {
  if (kind == RenderProgressKind::kVerbose) return ProgressStyle::kEveryLine;
  return Progress::usual_style();
}

std::string frame_line(const FrameReport& frame, bool interpolates) {
  if (frame.kind == "in-between" && interpolates)
    return fmt::format("frame {}: {:.3f} s, between key frames, {} pixels missed", frame.frame, frame.seconds,
                       frame.missed_pixels);
  if (frame.kind == "in-between")
    return fmt::format("frame {}: {:.3f} s, {} pixels copied from the key frame", frame.frame, frame.seconds,
                       frame.reused_pixels);
  return fmt::format("frame {}: {:.3f} s, {:.2f} million rays", frame.frame, frame.seconds,
                     static_cast<double>(frame.rays.total()) * 1e-6);
}

std::string count_of(int number, const char* thing) { return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s"); }

/// Describes the plan, as "480 frames of 3360x3360 pixels to out/teapot; all files: about 4.1 GB (an estimate)".
std::string describe(const RenderPlan& plan, int wanted, double bytes) {
  const std::string size = fmt::format("{}x{} pixels", plan.picture_size.x, plan.picture_size.y);
  const std::string each = plan.pictures_per_frame > 1 ? count_of(plan.pictures_per_frame, "picture") + ", each of " : "";
  const std::string kept = plan.kept > 0 ? fmt::format(" ({} more are rendered already)", plan.kept) : "";
  const std::string folder = plan.folder.empty() ? "." : plan.folder.string();
  const std::string what = plan.strips > 0 ? fmt::format("{}{} of {}", count_of(wanted, "strip"), kept,
                                                         count_of(static_cast<int>(plan.frames.size()), "frame"))
                                           : count_of(wanted, "frame") + kept;
  return fmt::format("{} of {}{} to {}; all files: about {} (an estimate)", what, each, size, folder, bytes_text(bytes));
}

/// Prints how much of the depth will be shown if the optics cannot show the full depth of the scene.
void print_fitted_depth(const RenderPlan& plan, const RenderParams& params) {
  const PlacedOptics& placed = plan.stage.placed;
  if (placed.depth_scale >= 1.0f) return;
  const ShownDepth shown = shown_depth(plan.stage.array, placed.units_per_mm, placed.depth_scale, placed.optics);
  print_error("{}{}\n", depth_budget_sentence(shown, placed.optics, placed.depth_scale),
              params.optics.fit_depth ? "" : " --full-depth shows its full depth.");
}

std::string advice_for_less_work(const RenderPlan& plan) {
  const int first = plan.frames.front(), last = plan.frames.back();
  const std::string fewer =
      plan.frames.size() > 1 ? fmt::format("--frames {} or {}-{}:10 (every 10th) for fewer frames, ", first, first, last) : "";
  return fmt::format("To do less: {}--spp for fewer samples, --size for fewer pixels. Ctrl-C stops, --resume goes on.", fewer);
}

}  // namespace

RenderProgress::RenderProgress(const RenderPlan& plan, const RenderParams& params, RenderProgressKind kind)
    : kind_(kind),
      interpolates_(params.reuse.choice == ReuseChoice::kInterpolate),
      frames_(plan.strips > 0 ? plan.strips : static_cast<int>(plan.frames.size())),
      wanted_(frames_ - plan.kept) {
  if (kind == RenderProgressKind::kNone) return;
  const FileSizes sizes = estimated_file_sizes(plan, params);
  estimated_at_first_ = sizes.all(), video_bytes_ = sizes.videos;
  if (kind == RenderProgressKind::kJson) {
    print_object(-1);
    heartbeat_.emplace([this] { tick(); });
    return;
  }
  if (wanted_ == 0) return;
  print_error("{}\n", describe(plan, wanted_, sizes.all()));
  print_fitted_depth(plan, params);
  progress_ = std::make_unique<Progress>(wanted_, style_of(kind));
  progress_->set_advice(advice_for_less_work(plan));
  heartbeat_.emplace([this] { tick(); });
}

RenderProgress::~RenderProgress() = default;

void RenderProgress::traced(const FrameReport& frame) {
  if (!progress_) return;
  if (style_of(kind_) == ProgressStyle::kBar) return progress_->step("");
  const std::lock_guard lock(mutex_);
  lines_[frame.frame] = frame_line(frame, interpolates_);
}

void RenderProgress::written(int frame, std::uintmax_t bytes) {
  if (kind_ == RenderProgressKind::kNone) return;
  const std::lock_guard lock(mutex_);
  ++written_;
  bytes_ += static_cast<double>(bytes);
  within_ = 0.0;
  if (kind_ == RenderProgressKind::kJson) {
    schedule_.is_due(written_, wanted_, seconds());
    return print_object(frame);
  }
  if (!progress_) return;
  const double size = estimated_bytes();
  const bool all = written_ == wanted_;
  progress_->set_note(fmt::format("files: {}{}", all && video_bytes_ == 0.0 ? "" : "about ", bytes_text(size)));
  if (style_of(kind_) == ProgressStyle::kBar) return;
  progress_->step(lines_[frame]);
  lines_.erase(frame);
}

void RenderProgress::within(double share) {
  if (progress_) return progress_->within(share);
  if (kind_ != RenderProgressKind::kJson) return;
  const std::lock_guard lock(mutex_);
  within_ = std::max(within_, share < 1.0 ? share : 0.0);
}

void RenderProgress::tick() {
  if (progress_) return progress_->tick();
  const std::lock_guard lock(mutex_);
  if (written_ < wanted_ && schedule_.is_due_within(seconds())) print_object(-1);
}

double RenderProgress::estimated_bytes() const {
  return written_ == 0 ? estimated_at_first_ : bytes_ / written_ * frames_ + video_bytes_;
}

void RenderProgress::print_object(int frame) const {
  const double elapsed_s = seconds(), done = written_ + within_;
  using Json = nlohmann::ordered_json;
  const Json json{{"frame", frame < 0 ? Json(nullptr) : Json(frame)},
                  {"done", written_},
                  {"frames", wanted_},
                  {"share", wanted_ > 0 ? std::min(1.0, done / wanted_) : 1.0},
                  {"seconds", elapsed_s},
                  {"seconds_left", done > 0.0 ? Json(seconds_left(elapsed_s, done, wanted_)) : Json(nullptr)},
                  {"bytes", static_cast<std::uint64_t>(bytes_)},
                  {"estimated_bytes", static_cast<std::uint64_t>(estimated_bytes())}};
  print_error("{}\n", json_to_text(json, -1));
}

}  // namespace lippmann::app
