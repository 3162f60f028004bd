#include "frames/error_bounded_frames.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "frames/forward_source.hpp"
#include "lippmann/image/metrics.hpp"
#include "reuse/frame_plan.hpp"
#include "reuse/in_between.hpp"
#include "reuse/tracing_costs.hpp"
#include "trace/trace_packets.hpp"

namespace lippmann {
namespace {

/// A segment consists of this many key frame intervals. A trial in its first interval decides whether the segment's frames are
/// predicted.
constexpr int kSegmentIntervals = 8;
/// If predicting a frame costs more than this, relative to tracing the frame, all frames of the segment are traced.
constexpr double kMostPredictionCost = 1.0 / 3.0;
/// Lowest saving for which frames are predicted, as a fraction of the cost of tracing all frames of an interval.
constexpr double kLeastIntervalSaving = 0.05;
/// Assumed saving if an interval is halved: the cost of tracing a predicted frame's uncertain pixels falls by this fraction of
/// the cost of tracing a whole frame.
constexpr double kHalvingGains = 0.1;

void add_spent(const FrameReport& spent, FrameReport& report) {
  report.seconds += spent.seconds;
  report.cpu_seconds += spent.cpu_seconds;
  add(spent.rays, report.rays);
}

float position(int frame, const FrameInterval& interval) {
  return static_cast<float>(frame - interval.first) / static_cast<float>(interval.last - interval.first);
}

/// Returns the PSNR of the estimated error. If all pixels that were traced to measure the error have an error of 0, returns the
/// PSNR of the upper bound.
double estimated_psnr(const ErrorEstimate& error) { return psnr_db(error.mse > 0.0 ? error.mse : error.bound); }

class ErrorBoundedFrames final : public FrameMaker {
 public:
  ErrorBoundedFrames(const MakerParts& parts, const Interpolate& reuse);

  RenderedFrame make(int frame) override;
  std::vector<FrameReport> sources() const override;

 private:
  struct Segment {
    int length = 0;
    Evidence evidence;
  };

  void render(int frame);
  void render_between(int frame, const FrameInterval& interval, const Evidence& learned);
  const Segment& segment_of(int frame);
  Segment try_segment(int first);
  FloorLesson learn(const FrameInterval& interval);
  /// Predicts the middle frame of an interval. Returns whether the prediction was kept.
  bool middle_holds(const FrameInterval& interval, const Evidence& learned);
  /// Traces the frame if prediction does not pay off. Returns whether it was predicted.
  bool predict_or_trace(int frame, const FrameInterval& interval, const Evidence& learned);
  void trace(int frame, const FrameReport& spent = {});
  const PointImage& key(int frame);
  void forget_before(int frame);
  RenderedFrame take(int frame);

  MakerParts parts_;
  Interpolate reuse_;
  int every_, last_frame_;
  InBetweenMaker maker_;
  std::map<int, ForwardSource> keys_;
  std::map<int, RenderedFrame> films_;  ///< finished frames that make() has not returned yet
  std::map<int, Segment> segments_;
  std::map<int, bool> middle_holds_;
  std::map<int, FrameReport> source_reports_;
};

ErrorBoundedFrames::ErrorBoundedFrames(const MakerParts& parts, const Interpolate& reuse)
    : parts_(parts),
      reuse_(reuse),
      every_(key_frame_interval(reuse)),
      last_frame_(parts.stage.scene.timeline.frame_count - 1),
      maker_(parts.stage.scene, parts.stage.placed.optics, forward_params(parts.sampling, reuse)) {}

RenderedFrame ErrorBoundedFrames::make(int frame) {
  std::erase_if(films_, [&](const auto& film) { return film.first < frame; });
  if (!films_.contains(frame) && !keys_.contains(frame)) render(frame);
  return parts_.context.cancelled ? RenderedFrame{} : take(frame);
}

void ErrorBoundedFrames::render(int frame) {
  const Segment& segment = segment_of(frame);
  if (parts_.context.cancelled || films_.contains(frame) || keys_.contains(frame)) return;
  if (segment.length == 0) {
    forget_before(frame);
    trace(frame);
  } else if (is_key_frame(frame, segment.length, last_frame_)) {
    forget_before(frame);
    key(frame);
  } else {
    render_between(frame, key_interval(frame, segment.length, last_frame_), segment.evidence);
  }
}

void ErrorBoundedFrames::render_between(int frame, const FrameInterval& interval, const Evidence& learned) {
  forget_before(interval.first);
  const bool holds = middle_holds(interval, learned);
  if (parts_.context.cancelled || films_.contains(frame)) return;
  if (holds)
    predict_or_trace(frame, interval, learned);
  else
    trace(frame);
}

const ErrorBoundedFrames::Segment& ErrorBoundedFrames::segment_of(int frame) {
  const int first = frame - frame % (kSegmentIntervals * every_);
  const auto known = segments_.find(first);
  return known != segments_.end() ? known->second : segments_[first] = try_segment(first);
}

ErrorBoundedFrames::Segment ErrorBoundedFrames::try_segment(int first) {
  const Vec2i film = film_size(parts_.stage.placed.optics);
  const std::uint64_t pixels = static_cast<std::uint64_t>(film.x) * static_cast<std::uint64_t>(film.y);
  if (last_frame_ - first < 2) return {};
  key(first);
  const double prediction = prediction_cost(parts_.stage.scene, keys_.at(first).report.rays, pixels);
  if (prediction > kMostPredictionCost) return {};
  for (int length = every_; length > 1 && !parts_.context.cancelled; length /= 2) {
    const FrameInterval interval{first, std::min(first + length, last_frame_)};
    const FloorLesson lesson = learn(interval);
    const auto saving = [&](int frames, double cost) { return (1.0 - prediction - cost) * (frames - 1) / frames; };
    if (saving(length, lesson.cost) >= kLeastIntervalSaving) return {length, lesson.evidence};
    const bool may_halve = !reuse_.keyframes && interval.last - first == length;
    if (!may_halve || saving(length / 2, lesson.cost - kHalvingGains) < kLeastIntervalSaving) break;
  }
  return {};
}

FloorLesson ErrorBoundedFrames::learn(const FrameInterval& interval) {
  const int middle = middle_frame(interval);
  const PointImage &previous = key(interval.first), &following = key(interval.last), &traced = key(middle);
  if (parts_.context.cancelled) return {};
  const FrameClock clock(parts_.pool);
  FloorLesson lesson = maker_.learn_floor({previous, following, position(middle, interval)}, middle, traced, parts_.pool);
  FrameReport& report = keys_.at(middle).report;
  clock.add_to(report);
  report.kind = "full";
  source_reports_[middle] = report;
  return lesson;
}

bool ErrorBoundedFrames::middle_holds(const FrameInterval& interval, const Evidence& learned) {
  const int middle = middle_frame(interval);
  if (keys_.contains(middle)) return true;  // learn() has traced the middle frame
  if (const auto known = middle_holds_.find(middle); known != middle_holds_.end()) return known->second;
  const bool holds = predict_or_trace(middle, interval, learned);
  return middle_holds_[middle] = holds;
}

bool ErrorBoundedFrames::predict_or_trace(int frame, const FrameInterval& interval, const Evidence& learned) {
  const PointImage &previous = key(interval.first), &following = key(interval.last);
  const FrameClock clock(parts_.pool);
  PointImage image;
  image.moment = parts_.stage.moment_at(frame);
  RayCounts rays;
  bool updated = false;
  const TracePackets trace = [&](std::span<const std::uint8_t> wanted, Image& film) {
    if (!updated) parts_.stage.device.update(image.moment.resolved, parts_.pool);
    updated = true;
    add(trace_packets(parts_.stage.shot(image.moment), trace_params(parts_.sampling, parts_.stage), wanted,
                      {parts_.pool, parts_.context}, film),
        rays);
  };
  InBetweenCounts counts;
  const FloorOutcome outcome =
      maker_.make_to_floor({previous, following, position(frame, interval)}, frame, learned, trace, parts_.pool, image, counts);
  FrameReport report = in_between_report(frame, counts, rays, film_size(parts_.stage.placed.optics));
  if (outcome.holds) {
    report.estimated_psnr_db = estimated_psnr(outcome.error);
    report.psnr_at_least_db = psnr_db(outcome.error.bound);
  }
  clock.add_to(report);
  if (outcome.holds) {
    RenderedFrame& made = films_[frame];
    made.pictures.film = std::move(image.film);
    made.pictures.aovs = wanted_aovs(parts_.sampling);
    set_provenance(image.provenance, film_size(parts_.stage.placed.optics), made.pictures.aovs);
    made.report = report;
    source_reports_[frame] = report;
  } else if (!parts_.context.cancelled) {
    this->trace(frame, report);
  }
  return outcome.holds;
}

void ErrorBoundedFrames::trace(int frame, const FrameReport& spent) {
  RenderedFrame& rendered = films_[frame] = render_frame(parts_.stage, parts_.sampling, frame, parts_.pool, parts_.context);
  add_spent(spent, rendered.report);
  source_reports_[frame] = rendered.report;
}

const PointImage& ErrorBoundedFrames::key(int frame) {
  const auto known = keys_.find(frame);
  if (known != keys_.end()) return known->second.image;
  ForwardSource& source = keys_[frame] = trace_source(parts_, reuse_, frame, maker_);
  source_reports_[frame] = source.report;
  return source.image;
}

void ErrorBoundedFrames::forget_before(int frame) {
  std::erase_if(keys_, [&](const auto& source) { return source.first < frame; });
}

RenderedFrame ErrorBoundedFrames::take(int frame) {
  source_reports_.erase(frame);
  if (const auto made = films_.find(frame); made != films_.end()) return std::move(films_.extract(made).mapped());
  const FrameClock clock(parts_.pool);
  const ForwardSource& source = keys_.at(frame);
  RenderedFrame rendered;
  rendered.pictures.film = source.image.film;
  rendered.pictures.aovs = wanted_aovs(parts_.sampling);
  set_provenance(Provenance::kTraced, film_size(parts_.stage.placed.optics), rendered.pictures.aovs);
  rendered.report = source.report;
  clock.add_to(rendered.report);
  return rendered;
}

std::vector<FrameReport> ErrorBoundedFrames::sources() const {
  std::vector<FrameReport> reports;
  for (const auto& [frame, report] : source_reports_) reports.push_back(report);
  return reports;
}

}  // namespace

std::unique_ptr<FrameMaker> make_error_bounded_frames(const MakerParts& parts, const Interpolate& reuse) {
  return std::make_unique<ErrorBoundedFrames>(parts, reuse);
}

double error_bounded_frames_bytes_per_pixel() {
  constexpr double kFilm = 3 * sizeof(float), kPoint = sizeof(float) + sizeof(std::uint32_t), kContrast = 1;
  const int halvings = halving_depth(kDefaultKeyframes);
  const int images = 1 + halvings, films = halvings - 1;
  constexpr double kUncertainty = 2 * sizeof(std::uint64_t) + 2 * kFilm + 5;
  return images * (kFilm + kPoint + kContrast) + films * kFilm + kUncertainty;
}

int error_bounded_frames_per_segment(const Interpolate& reuse) { return kSegmentIntervals * key_frame_interval(reuse); }

}  // namespace lippmann
