#include "reuse/in_between.hpp"

namespace lippmann {
namespace {

/// How far the weights of the two frames go from equal ones (0) to nearness in time (1). Nearness lets light and shadow change
/// evenly; equal weights even out what either frame's samples miss. In between, both are better off than at either end.
constexpr float kNearness = 0.7f;

}  // namespace

InBetweenMaker::InBetweenMaker(const Scene& scene, const Optics& optics, const ForwardParams& params)
    : params_(params),
      panel_(optics.panel),
      groups_(make_motion_groups(scene)),
      splatter_(optics, params.splat),
      steps_(optics, params.splat.mode) {
  const bool by_view = params.splat.mode == SplatMode::kView;
  if (params.sampling == SplatSampling::kEpipolar && by_view && EpipolarSampler::suits(optics))
    sampler_.emplace(optics, scene.encoding);
}

void InBetweenMaker::prepare(PointImage& frame, const ThreadPool& pool) const {
  if (sampler_) sampler_->find_contrast(frame, pool);
}

InBetweenCounts InBetweenMaker::make(const PointImage& previous, const PointImage& following, float position, bool as_source,
                                     const TracePixels& trace, const ThreadPool& pool, PointImage& frame) {
  const Motion from_previous = motion_between(groups_, previous.moment, frame.moment);
  const Motion from_following = motion_between(groups_, following.moment, frame.moment);
  splatter_.splat(previous, from_previous, pool, landed_previous_);
  splatter_.splat(following, from_following, pool, landed_following_);
  const float weight = 0.5f + kNearness * (position - 0.5f);
  const SplatSource a{previous, from_previous, landed_previous_, 1.0f - weight};
  const SplatSource b{following, from_following, landed_following_, weight};
  if (frame.film.width != panel_.width || frame.film.height != panel_.height || frame.film.channels != 3)
    frame.film = Image(panel_.width, panel_.height, 3);  // else every pixel of it is written over
  average(a, b, sampler_ ? &*sampler_ : nullptr, pool, frame.film, missed_);
  if (as_source) average_points(a, b, pool, frame.points);

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

}  // namespace lippmann
