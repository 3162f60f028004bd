#include "frames/forward_frames.hpp"

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "frames/forward_source.hpp"
#include "image/spare_images.hpp"
#include "reuse/frame_plan.hpp"
#include "reuse/in_between.hpp"
#include "trace/trace_pixels.hpp"

namespace lippmann {
namespace {

bool is_source(int frame, const FrameInterval& interval) { return frame - interval.first > 1 || interval.last - frame > 1; }

class ForwardFrames final : public FrameMaker {
 public:
  ForwardFrames(const MakerParts& parts, const Interpolate& reuse);

  RenderedFrame make(int frame) override;
  void recycle(Image film) override { spare_films_.give(std::move(film)); }
  std::vector<FrameReport> sources() const override;

 private:
  using Source = ForwardSource;

  Source between(int frame, const FrameInterval& interval, bool as_source);
  /// Returns nested intervals. The first lies between two key frames. `frame` is made from the two end frames of the last.
  std::vector<FrameInterval> path_to(int frame) const;
  void keep_only_sources_of(int frame);
  const Source& key(int frame);
  const Source& add(Source source);

  MakerParts parts_;
  Interpolate reuse_;
  int every_, last_frame_;
  InBetweenMaker maker_;
  SpareImages spare_films_;
  std::map<int, Source> sources_;
  std::map<int, FrameReport> source_reports_;
};

ForwardFrames::ForwardFrames(const MakerParts& parts, const Interpolate& reuse)
    : parts_(parts),
      reuse_(reuse),
      every_(key_frame_interval(reuse)),
      last_frame_(parts.stage.scene.timeline.frame_count - 1),
      maker_(parts.stage.scene, parts.stage.placed.optics, forward_params(parts.sampling, reuse)) {}

RenderedFrame ForwardFrames::make(int frame) {
  keep_only_sources_of(frame);
  RenderedFrame rendered;
  rendered.pictures.aovs = wanted_aovs(parts_.sampling);
  const auto mark_provenance = [&](const Source& source) {
    set_provenance(source.image.provenance, film_size(parts_.stage.placed.optics), rendered.pictures.aovs);
  };
  const auto copy = [&](const Source& source) {
    const FrameClock clock(parts_.pool);
    mark_provenance(source);
    rendered.pictures.film = source.image.film;
    rendered.report = source.report;
    clock.add_to(rendered.report);
  };
  if (const auto known = sources_.find(frame); known != sources_.end()) {
    copy(known->second);
  } else if (is_key_frame(frame, every_, last_frame_)) {
    copy(key(frame));
  } else {
    const std::vector<FrameInterval> path = path_to(frame);
    key(path.front().first), key(path.front().last);
    for (std::size_t i = 0; i + 1 < path.size() && !parts_.context.cancelled; ++i)
      if (const int middle = middle_frame(path[i]); !sources_.contains(middle)) add(between(middle, path[i], true));
    if (parts_.context.cancelled) return rendered;
    if (reuse_.halving && is_source(frame, path.back())) {
      copy(add(between(frame, path.back(), true)));
    } else {
      Source made = between(frame, path.back(), false);
      mark_provenance(made);
      rendered.pictures.film = std::move(made.image.film);
      rendered.report = made.report;
    }
  }
  source_reports_.erase(frame);
  return rendered;
}

std::vector<FrameInterval> ForwardFrames::path_to(int frame) const {
  if (reuse_.halving) return halving_path(frame, every_, last_frame_);
  return {key_interval(frame, every_, last_frame_)};
}

void ForwardFrames::keep_only_sources_of(int frame) {
  std::set<int> needed{frame};
  if (!is_key_frame(frame, every_, last_frame_))
    for (const FrameInterval& interval : path_to(frame)) {
      needed.insert(interval.first);
      needed.insert(interval.last);
    }
  std::erase_if(sources_, [&](const auto& source) { return !needed.contains(source.first); });
}

const ForwardFrames::Source& ForwardFrames::key(int frame) {
  const auto known = sources_.find(frame);
  return known != sources_.end() ? known->second : add(trace_source(parts_, reuse_, frame, maker_));
}

const ForwardFrames::Source& ForwardFrames::add(Source source) {
  const int frame = source.report.frame;
  source_reports_[frame] = source.report;
  return sources_[frame] = std::move(source);
}

ForwardFrames::Source ForwardFrames::between(int frame, const FrameInterval& interval, bool as_source) {
  const FrameClock clock(parts_.pool);
  Source source;
  source.image.film = spare_films_.take();
  source.image.moment = parts_.stage.moment_at(frame);
  const Moment& moment = source.image.moment;
  RayCounts rays;
  const TracePixels trace = [&](std::span<const std::uint32_t> pixels, Image& film, PrimaryPoints* points) {
    parts_.stage.device.update(moment.resolved, parts_.pool);
    rays = trace_pixels(parts_.stage.shot(moment), trace_params(parts_.sampling, parts_.stage), pixels,
                        {parts_.pool, parts_.context}, film, points);
  };
  const float position = static_cast<float>(frame - interval.first) / static_cast<float>(interval.last - interval.first);
  const SourcePair between{sources_.at(interval.first).image, sources_.at(interval.last).image, position};
  const InBetweenCounts counts = maker_.make(between, as_source, trace, parts_.pool, source.image);
  source.report = in_between_report(frame, counts, rays, film_size(parts_.stage.placed.optics));
  clock.add_to(source.report);
  return source;
}

std::vector<FrameReport> ForwardFrames::sources() const {
  std::vector<FrameReport> reports;
  for (const auto& [frame, report] : source_reports_) reports.push_back(report);
  return reports;
}

}  // namespace

std::unique_ptr<FrameMaker> make_forward_frames(const MakerParts& parts, const Interpolate& reuse) {
  return std::make_unique<ForwardFrames>(parts, reuse);
}

double forward_frames_bytes_per_pixel(const Interpolate& reuse) {
  constexpr double kFilm = 3 * sizeof(float), kPoint = sizeof(float) + sizeof(std::uint32_t), kContrast = 1, kSpareFilms = 2;
  const int images = 2 + (reuse.halving ? halving_depth(key_frame_interval(reuse)) : 0);
  return images * (kFilm + kPoint + kContrast) + 2 * sizeof(std::uint64_t) + kSpareFilms * kFilm;
}

}  // namespace lippmann
