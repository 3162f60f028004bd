#include "reuse/in_between.hpp"

#include <algorithm>

#include "lippmann/trace/aovs.hpp"

namespace lippmann {
namespace {

/// Preference for the source frame that is nearer in time. 0 gives equal weights, 1 gives weights linear in time. 0.7 has the
/// lowest measured error.
constexpr float kNearness = 0.7f;

float weight_at(float position) { return 0.5f + kNearness * (position - 0.5f); }

bool has_size(const Image& film, Vec2i size) { return film.width == size.x && film.height == size.y && film.channels == 3; }

Provenance provenance_of_missed(MissedFill fill) {
  constexpr Provenance kByFill[] = {Provenance::kFilled, Provenance::kRetraced, Provenance::kBlack};
  return kByFill[static_cast<std::size_t>(fill)];
}

void mark_traced(std::span<const std::uint32_t> pixels, std::vector<std::uint8_t>& provenance) {
  for (const std::uint32_t pixel : pixels) {
    const bool missed = provenance[pixel] == static_cast<std::uint8_t>(Provenance::kFilled);
    provenance[pixel] = static_cast<std::uint8_t>(missed ? Provenance::kRetraced : Provenance::kTraced);
  }
}

void blend(const Image& a, const Image& b, float weight_b, const ThreadPool& pool, Image& film) {
  constexpr std::size_t kPiece = std::size_t{1} << 15;
  const std::size_t values = film.data.size();
  pool.for_each((values + kPiece - 1) / kPiece, [&](std::size_t piece) {
    const std::size_t end = std::min(values, (piece + 1) * kPiece);
    for (std::size_t k = piece * kPiece; k < end; ++k) film.data[k] = a.data[k] + weight_b * (b.data[k] - a.data[k]);
  });
}

}  // namespace

InBetweenMaker::InBetweenMaker(const Scene& scene, const Optics& optics, const ForwardParams& params)
    : params_(params),
      film_size_(film_size(optics)),
      encoding_(scene.encoding),
      groups_(make_motion_groups(scene)),
      splatter_(optics, params.splat),
      steps_(optics, params.splat.mode == SplatMode::kLens ? StepsWithin::kLens : StepsWithin::kView) {
  const bool by_view = params.splat.mode == SplatMode::kView;
  if (params.sampling == SplatSampling::kEpipolar && by_view && EpipolarSampler::suits(optics))
    sampler_.emplace(optics, scene.encoding);
  if (!params.floor) return;
  uncertainty_estimator_.emplace(optics, scene.encoding);
  patches_.emplace(optics, params.order);
}

Image& InBetweenMaker::film_of(PointImage& frame) const {
  if (!has_size(frame.film, film_size_)) frame.film = Image(film_size_.x, film_size_.y, 3);
  return frame.film;
}

void InBetweenMaker::set_provenance(Provenance missed, PointImage& frame) const {
  if (!params_.wants_provenance) return;
  const auto pixels = static_cast<std::size_t>(film_size_.x) * static_cast<std::size_t>(film_size_.y);
  frame.provenance.assign(pixels, static_cast<std::uint8_t>(Provenance::kInterpolated));
  for (const std::uint32_t pixel : missed_) frame.provenance[pixel] = static_cast<std::uint8_t>(missed);
}

void InBetweenMaker::prepare(PointImage& frame, const ThreadPool& pool) const {
  if (sampler_) sampler_->find_contrast(frame, pool);
}

InBetweenCounts InBetweenMaker::make(const SourcePair& between, bool as_source, const TracePixels& trace,
                                     const ThreadPool& pool, PointImage& frame) {
  const auto& [previous, following, position] = between;
  const Motion from_previous = motion_between(groups_, previous.moment, frame.moment);
  const Motion from_following = motion_between(groups_, following.moment, frame.moment);
  splatter_.splat(previous, from_previous, pool, landed_previous_);
  splatter_.splat(following, from_following, pool, landed_following_);
  const float weight = weight_at(position);
  const SplatSource a{previous, from_previous, landed_previous_, 1.0f - weight};
  const SplatSource b{following, from_following, landed_following_, weight};
  average(a, b, sampler_ ? &*sampler_ : nullptr, pool, film_of(frame), missed_);
  if (as_source) average_points(a, b, pool, frame.points);

  set_provenance(provenance_of_missed(params_.fill), frame);

  InBetweenCounts counts;
  if (!missed_.empty()) {
    const Motion to_previous = motion_between(groups_, frame.moment, previous.moment);
    const Motion to_following = motion_between(groups_, frame.moment, following.moment);
    const SplatPair pair{a, b, to_previous, to_following};
    counts.missed = missed_.size();
    const bool from_neighbours = params_.fill == MissedFill::kInterpolate;
    counts.causes = resolve_missed(pair, splatter_, steps_, missed_, pool, from_neighbours ? &frame.film : nullptr);
    if (params_.fill == MissedFill::kRetrace) {
      trace(missed_, frame.film, as_source ? &frame.points : nullptr);
      counts.retraced = missed_.size();
    }
  }
  if (as_source) prepare(frame, pool);
  return counts;
}

void InBetweenMaker::predict(const SourcePair& between, const ThreadPool& pool, PointImage& frame, InBetweenCounts& counts) {
  const auto& [previous, following, position] = between;
  const Motion from_previous = motion_between(groups_, previous.moment, frame.moment);
  const Motion from_following = motion_between(groups_, following.moment, frame.moment);
  splatter_.splat(previous, from_previous, pool, landed_previous_);
  splatter_.splat(following, from_following, pool, landed_following_);
  for (Image* alone : {&from_previous_, &from_following_})
    if (!has_size(*alone, film_size_)) *alone = Image(film_size_.x, film_size_.y, 3);
  const EpipolarSampler* sampler = sampler_ ? &*sampler_ : nullptr;
  const SplatSource a{previous, from_previous, landed_previous_, 1.0f}, b{following, from_following, landed_following_, 1.0f};
  average(a, {following, from_following, landed_following_, 0.0f}, sampler, pool, from_previous_, missed_);
  average({previous, from_previous, landed_previous_, 0.0f}, b, sampler, pool, from_following_, missed_);
  blend(from_previous_, from_following_, weight_at(position), pool, film_of(frame));

  set_provenance(Provenance::kFilled, frame);
  counts.missed = missed_.size();
  if (!missed_.empty()) {
    const Motion to_previous = motion_between(groups_, frame.moment, previous.moment);
    const Motion to_following = motion_between(groups_, frame.moment, following.moment);
    counts.causes = resolve_missed({a, b, to_previous, to_following}, splatter_, steps_, missed_, pool, &frame.film);
  }
  uncertainty_estimator_->estimate({from_previous_, landed_previous_}, {from_following_, landed_following_}, frame.film, pool,
                                   uncertainty_);
}

FloorLesson InBetweenMaker::learn_floor(const SourcePair& between, int number, const PointImage& traced,
                                        const ThreadPool& pool) {
  PointImage predicted;
  predicted.moment = traced.moment;
  InBetweenCounts counts;
  predict(between, pool, predicted, counts);
  const std::vector<float> costs = patches_->costs(between.previous.rays);
  return lippmann::learn_floor(*params_.floor, {number, uncertainty_, *patches_, costs, encoding_}, predicted.film, traced.film,
                               pool);
}

FloorOutcome InBetweenMaker::make_to_floor(const SourcePair& between, int number, const Evidence& learned,
                                           const TracePackets& trace, const ThreadPool& pool, PointImage& frame,
                                           InBetweenCounts& counts) {
  predict(between, pool, frame, counts);
  const std::vector<float> costs = patches_->costs(between.previous.rays);
  const TracePackets tracing = [&](std::span<const std::uint8_t> wanted, Image& film) {
    trace(wanted, film);
    for (std::size_t p = 0; params_.wants_provenance && p < wanted.size(); ++p)
      if (wanted[p]) mark_traced(patches_->pixels(p), frame.provenance);
  };
  const FloorOutcome outcome =
      hold_floor(*params_.floor, {number, uncertainty_, *patches_, costs, encoding_}, learned, tracing, pool, frame.film);
  counts.retraced = outcome.retraced;
  return outcome;
}

}  // namespace lippmann
