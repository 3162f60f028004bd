#include "render/floored_frames.hpp"

#include <algorithm>
#include <utility>

#include "image/metrics.hpp"
#include "render/reuse_params.hpp"
#include "trace/trace_packets.hpp"

namespace lippmann {
namespace {

/// From here on the frames around are not tried: nearer keys would hardly make up for it.
constexpr double kHopelessShare = 0.75;

void add_spent(const FrameReport& spent, FrameReport& report) {
  report.seconds += spent.seconds;
  report.cpu_seconds += spent.cpu_seconds;
  add(spent.rays, report.rays);
}

/// An error of 0 among the held-out pixels is no proof that there is none.
double estimated_psnr(const ErrorEstimate& error) { return psnr_db(error.mse > 0.0 ? error.mse : error.bound); }

}  // namespace

FlooredFrames::FlooredFrames(Stage& stage, const RenderParams& params, const ThreadPool& pool, const Context& context)
    : stage_(stage),
      params_(params),
      pool_(pool),
      context_(context),
      every_(key_frame_interval(params)),
      last_frame_(stage.scene.timeline.frame_count - 1),
      maker_(stage.scene, stage.placed.optics, forward_params(params)) {}

RenderedFrame FlooredFrames::make(int frame) {
  forget_before(is_key_frame(frame, every_, last_frame_) ? frame : key_interval(frame, every_, last_frame_).first);
  std::erase_if(films_, [&](const auto& film) { return film.first < frame; });
  if (!films_.contains(frame) && !keys_.contains(frame)) render(frame);
  return context_.cancelled ? RenderedFrame{} : take(frame);
}

void FlooredFrames::render(int frame) {
  if (is_key_frame(frame, every_, last_frame_)) {
    key(frame);
    return;
  }
  FrameInterval interval = key_interval(frame, every_, last_frame_);
  while (!params_.keyframes) {
    const Verdict verdict = verdict_on_middle(interval);
    const int middle = middle_frame(interval);
    if (context_.cancelled || middle == frame) return;
    if (verdict == Verdict::kHolds) break;
    if (verdict == Verdict::kHopeless) {
      trace(frame, {});
      return;
    }
    interval = frame < middle ? FrameInterval{interval.first, middle} : FrameInterval{middle, interval.last};
  }
  forget_before(interval.first);
  predict_or_trace(frame, interval);
}

FlooredFrames::Verdict FlooredFrames::verdict_on_middle(const FrameInterval& interval) {
  const int middle = middle_frame(interval);
  const auto known = verdicts_.find(middle);
  return known != verdicts_.end() ? known->second : verdicts_[middle] = try_middle(interval);
}

FlooredFrames::Verdict FlooredFrames::try_middle(const FrameInterval& interval) {
  const int middle = middle_frame(interval);
  Attempt attempt = predict(middle, interval);
  if (attempt.holds) {
    not_asked_for_[middle] = attempt.frame.report;
    films_[middle] = std::move(attempt.frame);
    return Verdict::kHolds;
  }
  const bool hopeless = attempt.share_to_trace >= kHopelessShare, last = interval.last - interval.first == 2;
  if (hopeless || last)
    trace(middle, attempt.frame.report);
  else
    key(middle, attempt.frame.report);
  return hopeless ? Verdict::kHopeless : Verdict::kSplits;
}

FlooredFrames::Attempt FlooredFrames::predict(int frame, const FrameInterval& interval) {
  const PointImage &previous = key(interval.first), &following = key(interval.last);
  const FrameClock clock(pool_);
  PointImage image;
  image.moment = stage_.moment_at(frame);
  RayCounts rays;
  bool updated = false;
  const TracePackets trace = [&](std::span<const std::uint8_t> wanted, Image& film) {
    if (!updated) stage_.device.update(image.moment.resolved, pool_);
    updated = true;
    add(trace_packets(stage_.device, stage_.placed.optics, image.moment.world_from_display, trace_params(params_, stage_.scene),
                      wanted, pool_, context_, film),
        rays);
  };
  const float position = static_cast<float>(frame - interval.first) / static_cast<float>(interval.last - interval.first);
  InBetweenCounts counts;
  const FloorOutcome outcome = maker_.make_to_floor(previous, following, position, frame, trace, pool_, image, counts);
  Attempt attempt{{}, outcome.share_to_trace, outcome.holds};
  FrameReport& report = attempt.frame.report;
  report = in_between_report(frame, counts, rays, stage_.placed.optics.panel);
  if (outcome.holds) {
    report.estimated_psnr_db = estimated_psnr(outcome.error);
    report.psnr_at_least_db = psnr_db(outcome.error.bound);
    attempt.frame.pictures.film = std::move(image.film);
  }
  clock.add_to(report);
  return attempt;
}

void FlooredFrames::predict_or_trace(int frame, const FrameInterval& interval) {
  Attempt attempt = predict(frame, interval);
  if (!attempt.holds)
    trace(frame, attempt.frame.report);
  else
    films_[frame] = std::move(attempt.frame);
}

void FlooredFrames::trace(int frame, const FrameReport& spent) {
  RenderedFrame& rendered = films_[frame] = render_frame(stage_, params_, frame, pool_, context_);
  add_spent(spent, rendered.report);
  not_asked_for_[frame] = rendered.report;
}

const PointImage& FlooredFrames::key(int frame, const FrameReport& spent) {
  const auto known = keys_.find(frame);
  if (known != keys_.end()) return known->second.image;
  ForwardSource& source = keys_[frame] = trace_source(stage_, params_, frame, maker_, pool_, context_);
  add_spent(spent, source.report);
  not_asked_for_[frame] = source.report;
  return source.image;
}

void FlooredFrames::forget_before(int frame) {
  std::erase_if(keys_, [&](const auto& source) { return source.first < frame; });
}

RenderedFrame FlooredFrames::take(int frame) {
  not_asked_for_.erase(frame);
  if (const auto made = films_.find(frame); made != films_.end()) return std::move(films_.extract(made).mapped());
  const FrameClock clock(pool_);
  const ForwardSource& source = keys_.at(frame);
  RenderedFrame rendered;
  rendered.pictures.film = source.image.film;
  rendered.report = source.report;
  clock.add_to(rendered.report);
  return rendered;
}

std::vector<FrameReport> FlooredFrames::sources() const {
  std::vector<FrameReport> reports;
  for (const auto& [frame, report] : not_asked_for_) reports.push_back(report);
  return reports;
}

double FlooredFrames::bytes_kept_per_pixel() {
  constexpr double kFilm = 3 * sizeof(float), kPoint = sizeof(float) + sizeof(std::uint32_t), kContrast = 1;
  const int halvings = halving_depth(kDefaultKeyframes);
  const int images = 2 + halvings, films = halvings;
  constexpr double kDoubt = 2 * sizeof(std::uint64_t) + 2 * kFilm + 5;  // landed, predicted by either key, planes
  return images * (kFilm + kPoint + kContrast) + films * kFilm + kDoubt;
}

}  // namespace lippmann
