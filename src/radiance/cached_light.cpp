#include "radiance/cached_light.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "radiance/measured_codes.hpp"
#include "radiance/mending.hpp"
#include "radiance/plan_search.hpp"

namespace lippmann {
namespace {

/// What frames since restart() have found.
struct History {
  CacheHistory cells;
  std::optional<GatherPlan> plan;  ///< since the first frame; none: frames are traced, with
  int path_samples = 1;            ///< so many paths a pixel
  GatherEffort least{};            ///< the plan's effort as it was made: frames get no less
  bool has_to_mix = false;         ///< the frame before was good with paths alone
  FrameErrors errors;              ///< the errors of gathered frames
  FrameErrors path_errors;         ///< and those of traced ones
  int failures = 0;                ///< frames in a row that shared no light, or in vain (kMostFailures)
  Scatter scatter;                 ///< how the samples of the frame before scattered, where it was gathered
};

/// Where a frame errs by too much, a sample may have so much of the error that it might have before.
constexpr float kFiner = 0.75f, kFinerAtOnce = 0.6f;
/// Where pixels err by less than this part of what they may, they need not be sampled as finely.
constexpr float kSpare = 0.6f;
/// Where means err by less than the first part, fewer edges may be left to paths; by more than the second, more are, before it
/// takes mending.
constexpr float kSpareBlocks = 0.3f, kNear = 0.9f;
/// Where paths are mixed in, the next frame may have so many times as many.
constexpr float kMorePaths = 1.3f;
/// How often a frame is given more light and more samples before it is traced; and no more, once it has taken so many of the
/// rays that tracing takes.
constexpr int kAttempts = 4;
constexpr double kMostMending = 0.6;
/// After so many frames in a row that had to be traced, or that took so many of the rays of paths, the others of the history
/// are traced, too.
constexpr int kMostFailures = 3;
constexpr double kWorthless = 0.6;

/// Paths a pixel that err by no more than `goal`, where `samples` err by `found`: no fewer than these.
int path_samples_for(float goal, int samples, float found, int most) {
  const float wanted = std::ceil(static_cast<float>(samples) * found / std::max(goal, 1e-12f));
  return std::clamp(static_cast<int>(std::min(wanted, static_cast<float>(most))), samples, std::max(samples, most));
}

/// Null: not wanted.
Image* alpha_of(const CachedLightPictures& pictures) {
  return pictures.aovs && pictures.aovs->wants(Aov::kAlpha) ? &(*pictures.aovs)[Aov::kAlpha] : nullptr;
}

/// Null: not wanted; else all pixels are traced so far.
Image* allocated_provenance(Vec2i film, const CachedLightPictures& pictures) {
  if (!pictures.aovs || !pictures.aovs->wants(Aov::kProvenance)) return nullptr;
  pictures.aovs->allocate(Aov::kProvenance, film);
  return &(*pictures.aovs)[Aov::kProvenance];
}

/// Frames differ, and what was measured on planning's patches is among the best of what was tried.
PixelError expected_means(const FrameError& planned) {
  constexpr float kOfPlan = 0.3f;
  return {planned.blocks, std::hypot(planned.block_uncertainty, kOfPlan * planned.blocks)};
}

/// A goal that needs more than so many times the paths that were asked for is missed.
constexpr int kMostMorePaths = 64;

/// One frame on its way.
class CachedFrame {
 public:
  CachedFrame(const Shot& shot, const SurfacePlaces& places, const TraceParams& params, const Workers& workers,
              History& history)
      : shot_(shot),
        params_(params),
        pool_(workers.pool),
        context_(workers.context),
        history_(history),
        cache_(shot, places, params, workers, history.cells),
        before_(smoothed(history.scatter, shot.optics, workers.pool)) {}

  void begin_history(const CachedLightGoal& goal);
  void go_on(const std::vector<HorizonBox>& moving) { cache_.go_on(moving); }
  bool make_gathered(const CachedLightGoal& goal, const CachedLightPictures& pictures);
  void make_traced(const CachedLightGoal& goal, const CachedLightPictures& pictures);

  RayCounts counts() const;

  /// For a frame that was gathered, and did not begin a history: whether it took clearly fewer rays than paths do.
  bool was_worth_it() const { return was_worth_it_; }

 private:
  void learn_from(const FrameErrors& former);
  GatherEffort effort() { return {error(), history_.plan->edges, history_.plan->mix, history_.plan->worst}; }
  float& error() { return before_.empty() ? history_.plan->error_alone : history_.plan->error; }
  void gather(bool provenance, const CachedLightPictures& pictures);
  enum class Mending { kNone, kGood, kFailed };
  Mending mend(FrameErrors& former, GatherMeasure& measure);
  bool may_mend(const GatherMeasure& measure) const;
  void apply(const Remedy& remedy, int attempt);
  float expected_error(const GatherMeasure& measure) const;
  FrameError gather_apart(GatherMeasure& measure);
  std::optional<PathMix> mix_wanted(const GatherMeasure& measure, double share_of_rays) const;
  double share_before_mixing(const GatherMeasure& measure) const;
  Mending mix_paths(const GatherMeasure& measure, FrameErrors& former);
  FrameError error_without_mix(const GatherMeasure& measure) const;
  void adjust_mix(const GatherMeasure& measure, bool was_mixed);
  int path_samples(const CachedLightGoal& goal, int samples, float found) const;
  RayCounts trace_whole(const TraceParams& whole, const CachedLightPictures& pictures) const;
  FrameError measure_traced(const TraceParams& whole, const ErrorGoal& goal, bool shows_all, const Image& film);

  Shot shot_;
  const TraceParams& params_;
  const ThreadPool& pool_;
  const Context& context_;
  History& history_;
  FrameCache cache_;
  Scatter before_;                    ///< how the samples of the frame before scattered, smoothed
  RayCounts counts_;                  ///< but for those of cache_
  std::uint64_t rays_of_search_ = 0;  ///< in a history's first frame, for a plan that is for all frames: none is charged for it
  std::uint64_t rays_of_gather_ = 0;
  double expected_ = 0.0;  ///< GatherHistory::expected of what was gathered last
  bool was_worth_it_ = true;
};

RayCounts CachedFrame::counts() const {
  RayCounts counts = counts_;
  add(cache_.counts(), counts);
  return counts;
}

void CachedFrame::begin_history(const CachedLightGoal& goal) {
  PlanSearch search(shot_, params_, goal, {pool_, context_}, cache_);
  history_.plan = search.find();
  history_.least = history_.plan ? history_.plan->effort() : GatherEffort{};
  if (history_.plan) history_.errors.expect_means(expected_means(history_.plan->expected), search.goal().blocks);
  history_.path_samples = path_samples(goal, params_.spp, search.error_of_paths());
  add(search.counts(), counts_);
  rays_of_search_ = counts().total();
}

/// As much is done as frames before have needed.
void CachedFrame::learn_from(const FrameErrors& former) {
  GatherPlan& plan = *history_.plan;
  const FrameError &found = former.found(), &may = former.allowed();
  if (plan.mix.samples > 0) return;
  if (found.pixels < kSpare * may.pixels) plan.error = std::min(plan.error / kFiner, history_.least.error);
  if (found.blocks > kNear * may.blocks)
    plan.edges = more_edges(plan.edges);
  else if (found.blocks < kSpareBlocks * may.blocks)
    plan.edges = std::max(fewer_edges(plan.edges), history_.least.edges);
}

/// A frame from the cache, if it errs by no more than it may; else a traced one. Whether it is the former.
bool CachedFrame::make_gathered(const CachedLightGoal& goal, const CachedLightPictures& pictures) {
  GatherMeasure measure(shot_, params_, goal.error, cache_.is_first() ? kCheckingFirst : kChecking, before_, {pool_, context_});
  FrameErrors former = history_.errors;
  const bool was_mixed = history_.plan->mix.samples > 0;
  learn_from(former);
  const bool shows_all = !goal.provenance && !alpha_of(pictures);  // as the paths that are compared with
  const auto gather_and_measure = [&] {
    gather(goal.provenance, pictures);
    measure.choose_pixels_of(pictures.film, history_.scatter);
    const FrameError apart = shows_all ? FrameError{} : gather_apart(measure);
    history_.errors = former;
    history_.errors.add(shows_all ? measure.error_of(pictures.film) : apart, measure.goal(), expected_error(measure));
  };
  gather_and_measure();
  Mending mending = Mending::kNone;
  // A goal in time leaves none to mend anything.
  if (!goal.seconds && !context_.cancelled) mending = mend(former, measure);
  if (mending == Mending::kGood) gather_and_measure();

  if (mending != Mending::kFailed && !goal.seconds) adjust_mix(measure, was_mixed);
  if (mending == Mending::kFailed) {
    history_.errors = former;  // this one is not among them any more
    make_traced(goal, pictures);
  }
  add(measure.counts(), counts_);
  was_worth_it_ = cache_.is_first() || static_cast<double>(counts().total()) < kWorthless * measure.rays_of_whole_frame();
  return mending != Mending::kFailed;
}

/// What pixels are expected to err by, mixed with paths as they are.
float CachedFrame::expected_error(const GatherMeasure& measure) const {
  return measure.with(history_.plan->mix, static_cast<float>(expected_));
}

/// What the frame's patches err by, gathered by themselves.
FrameError CachedFrame::gather_apart(GatherMeasure& measure) { return measure.check(cache_.sources(), effort(), before_); }

/// Where the frame errs by more than it may, it is given more light and more samples, as often as may help. With paths mixed
/// in, cells that are wrong have had their chance.
CachedFrame::Mending CachedFrame::mend(FrameErrors& former, GatherMeasure& measure) {
  FrameErrors& errors = history_.errors;
  const FrameError& may = measure.goal();
  FrameError left = errors.latest();
  int attempts = 0;
  for (bool helps = history_.plan->mix.samples == 0 || is_of_pixels(errors, left, may);
       helps && attempts < kAttempts && !errors.is_good() && !is_hopeless(left, may) && may_mend(measure); ++attempts) {
    const Remedy remedy = remedy_for(errors, left, may, history_.plan->edges);
    apply(remedy, attempts);
    const FrameError now = gather_apart(measure);
    errors = former;
    errors.add(now, may);
    helps = has_helped(remedy, errors, left, now);
    left = now;
  }
  const Mending mixed = mix_paths(measure, former);
  return mixed == Mending::kNone && attempts > 0 ? Mending::kGood : mixed;
}

/// A first frame that took many rays would take them again, and a still has no others that gain by it.
bool CachedFrame::may_mend(const GatherMeasure& measure) const {
  const std::uint64_t anew = cache_.is_first() ? rays_of_gather_ : 0;
  const auto spent = static_cast<double>(counts().total() - rays_of_search_ + measure.counts().total() + anew);
  return spent <= kMostMending * measure.rays_of_whole_frame() && !context_.cancelled;
}

void CachedFrame::apply(const Remedy& remedy, int attempt) {
  if (remedy.finer_pixels) error() *= kFinerAtOnce;
  if (remedy.more_edges) history_.plan->edges = more_edges(more_edges(history_.plan->edges));
  if (remedy.more_updates) cache_.update_more(attempt);
}

/// By what this frame errs with those before, as it alone knows little, less what is mixed in.
FrameError CachedFrame::error_without_mix(const GatherMeasure& measure) const {
  const FrameError may = measure.goal(), &found = history_.errors.found(), &allowed = history_.errors.allowed();
  const float times = may.blocks / allowed.blocks;
  const FrameError mixed{found.pixels / allowed.pixels * may.pixels, times * found.blocks, 0.0f,
                         times * found.block_uncertainty};
  return measure.without(history_.plan->mix, mixed);
}

std::optional<PathMix> CachedFrame::mix_wanted(const GatherMeasure& measure, double share_of_rays) const {
  return measure.mix_for(error_without_mix(measure), share_of_rays);
}

/// For the next frame: one that needs paths may have had bad luck, two in a row have not.
void CachedFrame::adjust_mix(const GatherMeasure& measure, bool was_mixed) {
  PathMix& mix = history_.plan->mix;
  const bool had_to_mix = std::exchange(history_.has_to_mix, mix.samples > 0);
  if (mix.samples == 0) return;
  const FrameError without = error_without_mix(measure);
  if (!was_mixed && !had_to_mix) {
    mix = {};
  } else {
    const std::optional<PathMix> wanted = measure.mix_for(without, 0.0);
    const float more = wanted ? static_cast<float>(wanted->samples) / static_cast<float>(mix.samples) : kMorePaths;
    mix = scaled(mix, std::clamp(more, 1.0f / kMorePaths, kMorePaths), params_.spp);
  }
  const FrameError next = measure.mixed(mix, without);
  history_.errors.expect_means({next.blocks, next.block_uncertainty}, measure.goal().blocks);
}

/// The share of a whole frame's rays that count where paths are mixed in. A history's first frame counts only what gathering it
/// anew takes, as a still has nothing else to lose.
double CachedFrame::share_before_mixing(const GatherMeasure& measure) const {
  const auto share = [&](std::uint64_t rays) { return static_cast<double>(rays) / measure.rays_of_whole_frame(); };
  if (!cache_.is_first()) return share(counts().total() + rays_of_gather_);
  return share(rays_of_gather_) - static_cast<double>(history_.plan->mix.samples) / params_.spp;
}

/// What is still wrong averages out with that of a few paths.
CachedFrame::Mending CachedFrame::mix_paths(const GatherMeasure& measure, FrameErrors& former) {
  const FrameErrors& errors = history_.errors;
  if (!errors.is_too_large()) return Mending::kNone;
  const std::optional<PathMix> mix = mix_wanted(measure, share_before_mixing(measure));
  if (!mix) return !cache_.is_first() || is_far_off(errors.latest(), measure.goal()) ? Mending::kFailed : Mending::kNone;
  const FrameError mixed = measure.mixed(*mix, error_without_mix(measure));
  former.expect_means({mixed.blocks, mixed.block_uncertainty}, measure.goal().blocks);
  history_.plan->mix = *mix;
  return Mending::kGood;
}

void CachedFrame::gather(bool provenance, const CachedLightPictures& pictures) {
  Image* const alpha = alpha_of(pictures);
  if (alpha) pictures.aovs->allocate(Aov::kAlpha, film_size(shot_));
  const RayCounts rays =
      gather_frame(cache_.sources(), {params_, effort(), provenance}, {}, {&before_, &history_.scatter, &expected_},
                   {pool_, context_}, {pictures.film, alpha, pictures.noisy, allocated_provenance(film_size(shot_), pictures)});
  add(rays, counts_);
  rays_of_gather_ = rays.total();
}

/// Paths, as many as the goal is known to take; where these fall short, the frames after have more.
void CachedFrame::make_traced(const CachedLightGoal& goal, const CachedLightPictures& pictures) {
  TraceParams whole = params_;
  whole.spp = history_.path_samples;
  allocated_provenance(film_size(shot_), pictures);
  add(trace_whole(whole, pictures), counts_);
  if (context_.cancelled) return;
  const FrameError found = measure_traced(whole, goal.error, !alpha_of(pictures), pictures.film);
  history_.path_errors.add(found, found);
  history_.path_samples = path_samples(goal, history_.path_samples, history_.path_errors.found().pixels);
}

RayCounts CachedFrame::trace_whole(const TraceParams& whole, const CachedLightPictures& pictures) const {
  FrameAovs none;
  FrameAovs& aovs = pictures.aovs ? *pictures.aovs : none;
  if (!pictures.noisy) return trace_frame(shot_, whole, {pool_, context_}, {pictures.film, &aovs});
  const RayCounts rays = trace_noisy_frame(shot_, whole, {pool_, context_}, *pictures.noisy, aovs);
  pictures.film = std::exchange(pictures.noisy->film, {});
  return rays;
}

int CachedFrame::path_samples(const CachedLightGoal& goal, int samples, float found) const {
  if (!goal.error.squared) return samples;
  return path_samples_for(*goal.error.squared, samples, found, kMostMorePaths * params_.spp);
}

/// shows_all: the surroundings, too, as the paths do that it is compared with.
FrameError CachedFrame::measure_traced(const TraceParams& whole, const ErrorGoal& goal, bool shows_all, const Image& film) {
  MeasuredPixels where = choose_pixels(film, kWatching, {}, hash(params_.seed, params_.frame));
  const PixelMeasure measure(shot_, whole, std::move(where), shows_all ? 1 : 2, {pool_, context_});
  add(measure.counts(), counts_);
  const PixelError single = shows_all ? measure.of_paths(film) : measure.of_paths();
  const EyeBlur blur(shot_.optics, goal.crosstalk_px);
  PixelError at_eye = single;
  if (blur.blurs()) {
    const std::vector<float> light = shows_all ? light_at(film, measure.where().pixels) : measure.light(1);
    at_eye = eye_error_of_paths({blur, film, pool_}, measure, light);
  }
  const PixelError &judged = goal.at_eye ? at_eye : single, &other = goal.at_eye ? single : at_eye;
  // Errors of paths have nothing to do with each other, from pixel to pixel.
  return {judged.squared, single.squared / kBlockPixels, judged.uncertainty, single.uncertainty / kBlockPixels, other};
}

}  // namespace

struct CachedLightTracer::Impl {
  explicit Impl(const DeviceScene& of) : places(of.shaded()) {}

  SurfacePlaces places;
  History history;
};

CachedLightTracer::CachedLightTracer(const DeviceScene& scene) : impl_(std::make_unique<Impl>(scene)) {}

CachedLightTracer::~CachedLightTracer() = default;

void CachedLightTracer::restart() { impl_->history = {}; }

double CachedLightTracer::bytes_per_pixel(double covered) {
  // Scatter of samples, as it is and smoothed, and a round of records; cells are fewer per pixel the larger surfaces appear.
  constexpr double kPixels = 26.0, kCells = 75.0;
  return kPixels + kCells * std::sqrt(covered);
}

CachedLightReport CachedLightTracer::trace(const Shot& shot, const ResolvedScene& resolved, const TraceParams& params,
                                           const CachedLightGoal& goal, const std::vector<HorizonBox>& moving,
                                           const Workers& workers, const CachedLightPictures& pictures) {
  History& history = impl_->history;
  impl_->places.update(resolved);
  CachedFrame frame(shot, impl_->places, params, workers, history);
  if (!history.cells.cache)
    frame.begin_history(goal);
  else if (history.plan)
    frame.go_on(moving);
  CachedLightReport report;
  if (!workers.context.cancelled && history.plan) {
    report.traced = !frame.make_gathered(goal, pictures);
    history.failures = report.traced || !(goal.seconds || frame.was_worth_it()) ? history.failures + 1 : 0;
    if (history.failures >= kMostFailures) history.plan.reset();
  } else if (!workers.context.cancelled) {
    report.traced = true;
    frame.make_traced(goal, pictures);
  }
  const FrameErrors& errors = report.traced ? history.path_errors : history.errors;
  report.pixels = goal.error.at_eye ? errors.other_of_latest() : errors.of_latest();
  report.at_eye = goal.error.at_eye ? errors.of_latest() : errors.other_of_latest();
  report.block_squared_error = static_cast<double>(errors.found().blocks);
  report.rays = frame.counts();
  return report;
}

}  // namespace lippmann
