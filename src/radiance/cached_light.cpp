#include "radiance/cached_light.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "radiance/frame_errors.hpp"
#include "radiance/setup_search.hpp"
#include "radiance/update_frame.hpp"

namespace lippmann {
namespace {

/// Cells are as small as the first round of records allows: the more pixels see a place, the smaller.
constexpr float kLargestCell = 8.0f, kSmallestCell = 2.0f;
constexpr double kLeastPerCell = 8.0;

/// How many samples a cell should have: so many times the mean after the first frame's updates, but beyond kEnough of that mean
/// no more than kMostWanted. Cells with fewer get more in every frame. More than the mean, as what moves and what changes is
/// forgotten: with less, frames get worse from the first on.
constexpr float kWanted = 4.0f, kMostWanted = 96.0f, kEnough = 0.8f;

/// Textures are filtered as of so many samples a pixel: wider, and they blur what paths show sharply; narrower, and pixels need
/// more samples.
constexpr int kTextureSamples = 16;

/// The cache grows to so many cells; smooth scenes need 0.1 to 0.2 of a pixel's, leaves of a pixel's size 0.5.
constexpr double kCellsPerPixel = 1.0;
constexpr double kLeastCells = 65536.0;

/// Rays of a whole frame that may be spent to find out how to begin, and that it is better to trace paths: a part of what the
/// history can save.
double most_spent(int frames) { return std::clamp(0.04 * frames, 0.3, 0.65); }

/// Errors of cells fall as the number of updates to the power of one over this: measured, where updates doubled, 0.9 to 2.2 in
/// stills of four scenes (CornellBox, spot, a teapot, nine spheres of glass and gloss).
constexpr double kUpdatesPerExcess = 1.5;

/// What frames since restart() have found.
struct History {
  std::optional<RadianceCache> cache;  ///< none: no frame yet
  float samples_per_cell = 0.0f;       ///< of CacheCells, since the first frame
  LightGroup lights_from{};            ///< likewise
  int rounds = 0;                      ///< of updates in the first frame
  float mean = 0.0f;                   ///< samples of a cell that it gave
  float enough = 0.0f;                 ///< samples of a cell (kWanted)
  std::optional<GatherPlan> plan;      ///< since the first frame; none: frames are traced, with
  int path_samples = 1;                ///< so many paths a pixel
  GatherEffort least{};                ///< of the plan, as it was made
  bool has_to_mix = false;             ///< the frame before was good with paths alone
  FrameErrors errors;                  ///< of frames that were gathered
  FrameErrors path_errors;             ///< and of those that were traced
  int failures = 0;                    ///< frames in a row that shared no light, or in vain (kMostFailures)
  Scatter scatter;                     ///< of the frame before, where it was gathered
};

/// Where a frame errs by too much, a sample may have so much of the error that it might have before.
constexpr float kFiner = 0.75f, kFinerAtOnce = 0.6f;
/// Where pixels err by less than this part of what they may, they need not be sampled as finely: what is wrong then is the
/// light.
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
/// An error so many times as large as it may be is more than that makes up for.
constexpr float kHopeless = 6.0f;
/// An attempt that leaves more than this share of the error has not helped.
constexpr float kHelped = 0.9f;
/// After so many frames in a row that had to be traced, or that took so many of the rays of paths, the others of the history
/// are traced, too.
constexpr int kMostFailures = 3;
constexpr double kWorthless = 0.6;

/// Paths a pixel that err by no more than `goal`, where `samples` err by `found`: no fewer than these.
int path_samples_for(float goal, int samples, float found, int most) {
  const float wanted = std::ceil(static_cast<float>(samples) * found / std::max(goal, 1e-12f));
  return std::clamp(static_cast<int>(std::min(wanted, static_cast<float>(most))), samples, std::max(samples, most));
}

/// Whether a frame has over twice the error that it may have. A history's first frame that has less stays as it is: to trace
/// it, too, would cost a small still two to three times what paths take.
bool is_far_off(const FrameError& found, const FrameError& may) {
  constexpr float kFarOff = 2.0f;
  return found.pixels > kFarOff * may.pixels || found.blocks > kFarOff * may.blocks;
}

/// Null: not wanted.
Image* alpha_of(const CachedLightPictures& pictures) {
  return pictures.aovs && pictures.aovs->wants(Aov::kAlpha) ? &(*pictures.aovs)[Aov::kAlpha] : nullptr;
}

/// A goal that needs more than so many times the paths that were asked for is missed.
constexpr int kMostMorePaths = 64;

/// One frame on its way.
class CachedFrame {
 public:
  CachedFrame(const Shot& shot, const SurfacePlaces& places, const TraceParams& params, const Workers& workers,
              History& history)
      : shot_(shot),
        places_(places),
        params_(params),
        pool_(workers.pool),
        context_(workers.context),
        history_(history),
        beam_(shot.optics, shot.world_from_display, kTextureSamples),
        updater_(shot, params),
        before_(smoothed(history.scatter, shot.optics, workers.pool)) {}

  void begin_history(const CachedLightGoal& goal);
  void go_on(const std::vector<HorizonBox>& moving);
  void learn_from(const FrameErrors& former);
  bool make_gathered(const CachedLightGoal& goal, const CachedLightPictures& pictures);
  void make_traced(const CachedLightGoal& goal, const CachedLightPictures& pictures);

  const RayCounts& counts() const { return counts_; }

  /// For a frame that was gathered, and did not begin a history: whether it took clearly fewer rays than paths do.
  bool was_worth_it() const { return was_worth_it_; }

 private:
  double seconds_for_pixels(double seconds) const;
  void set_up(const CacheSetup& setup, float fitting_cell);
  struct MixedSetup {
    CacheSetup setup;
    GatherPlan plan;
  };
  void keep_mixed(const GatherMeasure& measure, const CacheSetup& setup, std::optional<MixedSetup>& best) const;
  SetupOutcome try_setup(const CachedLightGoal& goal, GatherMeasure& measure);
  double rays_until_good(const SetupOutcome& outcome) const;
  void start_cache(float samples_per_cell, LightGroup lights_from);
  double samples_per_cell() const;
  float fitting_cell();
  void update(int rounds);
  GatherMeasure measure(const CachedLightGoal& goal, const MeasuredPlaces& places) const;
  void confirm(SetupOutcome& outcome, const FrameError& may, GatherMeasure& fresh);
  GatherEffort effort() { return {error(), history_.plan->edges, history_.plan->mix}; }
  float& error() { return before_.empty() ? history_.plan->error_alone : history_.plan->error; }
  void gather(bool provenance, const CachedLightPictures& pictures);
  enum class Mending { kNone, kGood, kFailed };
  Mending mend(const FrameErrors& former, GatherMeasure& measure);
  float expected_error(const GatherMeasure& measure) const;
  FrameError gather_apart(GatherMeasure& measure);
  std::optional<PathMix> mix_wanted(const GatherMeasure& measure, double share_of_rays) const;
  double share_before_mixing(const GatherMeasure& measure) const;
  Mending mix_paths(const GatherMeasure& measure);
  void adjust_mix(const GatherMeasure& measure, bool was_mixed);
  void update_more(int attempt);
  int path_samples(const CachedLightGoal& goal, int samples, float found) const;
  RayCounts trace_whole(const TraceParams& whole, const CachedLightPictures& pictures) const;
  FrameError measure_traced(const TraceParams& whole, bool shows_all, const Image& film);
  void update_sparse(const UpdateTarget& target, PacketGroups sparse, int first_round, int end);
  CacheCells cells() const { return {places_, beam_, history_.samples_per_cell, history_.lights_from}; }

  Shot shot_;
  const SurfacePlaces& places_;
  const TraceParams& params_;
  const ThreadPool& pool_;
  const Context& context_;
  History& history_;
  BeamFootprint beam_;
  CacheUpdater updater_;
  int round_ = 0;        ///< of updates, the next
  float enough_ = 0.0f;  ///< samples of a cell, in this frame
  double update_seconds_ = 0.0;
  std::size_t records_ = 0;          ///< added since start_cache()
  std::uint64_t rays_of_cache_ = 0;  ///< that brought them
  Scatter before_;                   ///< of the frame before
  std::optional<TouchProbe> moved_;
  RayCounts counts_;
  std::uint64_t rays_of_search_ = 0;  ///< in a history's first frame, for a plan that is for all frames: none is charged for it
  std::uint64_t rays_of_gather_ = 0;
  double expected_ = 0.0;  ///< of GatherHistory, of what was gathered last
  bool was_worth_it_ = true;
};

void CachedFrame::update(int rounds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const CacheCells in = cells();
  for (const int end = round_ + rounds; round_ < end && !context_.cancelled; ++round_) {
    const UpdateRound made = updater_.update({in, *history_.cache, pool_, context_}, round_);
    add(made.rays, counts_);
    records_ += made.records();
    rays_of_cache_ += made.rays.total();
  }
  update_seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
}

/// A little everywhere, and as much as the first frame was given where little is known: what was hidden before, and what has
/// changed; then whatever it takes.
void CachedFrame::go_on(const std::vector<HorizonBox>& moving) {
  RadianceCache& cache = *history_.cache;
  cache.begin_frame([this](std::uint32_t thing, Vec3f at) { return places_.moved(thing, at); }, pool_);
  const CacheCells in = cells();
  moved_.emplace(shot_.device.shaded(), moving);
  const UpdateTarget target{in, cache, pool_, context_, &*moved_};
  const UpdateRound everywhere = updater_.update(target, 0);
  add(everywhere.rays, counts_);
  // The more is forgotten, the more has to be found anew, as in the first frame.
  const float lost = cache.forget(pool_);
  enough_ = std::max(history_.enough, lost * history_.mean);
  PacketGroups sparse;
  add_sparse_groups(everywhere, cache, enough_, sparse);
  update_sparse(target, std::move(sparse), 1, history_.rounds);
  cache.resolve(pool_);
  round_ = history_.rounds;
}

/// Rounds of groups that have met sparse cells, until there are none any more.
void CachedFrame::update_sparse(const UpdateTarget& target, PacketGroups sparse, int first_round, int end) {
  PacketGroups still;
  for (int round = first_round; round < end && !context_.cancelled; ++round) {
    const UpdateRound made = updater_.update_sparse(target, round, enough_, sparse);
    add(made.rays, counts_);
    add_sparse_groups(made, target.cache, enough_, still);
    if (round % kRoundsPerFrame == 0) {  // all packets of a group have had their turn
      target.cache.forget(pool_);
      sparse = std::exchange(still, {});
    }
  }
  target.cache.forget(pool_);
}

GatherMeasure CachedFrame::measure(const CachedLightGoal& goal, const MeasuredPlaces& places) const {
  return {shot_, params_, goal.squared_error, places, before_, pool_};
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
  GatherMeasure measure = this->measure(goal, moved_ ? kChecking : kCheckingFirst);
  const FrameErrors former = history_.errors;
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
  was_worth_it_ = !moved_ || static_cast<double>(counts_.total()) < kWorthless * measure.rays_of_whole_frame();
  return mending != Mending::kFailed;
}

/// What pixels are expected to err by, mixed with paths as they are.
float CachedFrame::expected_error(const GatherMeasure& measure) const {
  return measure.with(history_.plan->mix, static_cast<float>(expected_));
}

/// What the frame's patches err by, gathered by themselves.
FrameError CachedFrame::gather_apart(GatherMeasure& measure) {
  const CacheCells in = cells();
  return measure.check({shot_, in, *history_.cache}, effort(), before_);
}

/// Where the frame errs by more than it may, it is given more light and more samples, as often as may help.
CachedFrame::Mending CachedFrame::mend(const FrameErrors& former, GatherMeasure& measure) {
  FrameErrors& errors = history_.errors;
  const FrameError& may = measure.goal();
  FrameError left = errors.latest();
  int attempts = 0;
  for (bool has_helped = history_.plan->mix.samples == 0;
       has_helped && attempts < kAttempts && !errors.is_good() && !context_.cancelled; ++attempts) {
    if (left.pixels > kHopeless * may.pixels || left.blocks > kHopeless * may.blocks) break;
    // A first frame that took many rays would take them again, and a still has no others that gain by it.
    const std::uint64_t anew = moved_ ? 0 : rays_of_gather_;
    const double spent = static_cast<double>(counts_.total() - rays_of_search_ + measure.counts().total() + anew);
    if (spent > kMostMending * measure.rays_of_whole_frame()) break;
    if (left.pixels > kSpare * may.pixels) error() *= kFinerAtOnce;
    // Where means err, edges are the likelier cause, and cost no updates.
    const bool is_of_edges = errors.blocks() != Excess::kNone && history_.plan->edges != EdgesToPaths::kFaint;
    if (is_of_edges)
      history_.plan->edges = more_edges(more_edges(history_.plan->edges));
    else
      update_more(attempts);
    const FrameError now = gather_apart(measure);
    errors = former;
    errors.add(now, may);
    has_helped = is_of_edges || (errors.pixels() != Excess::kNone && now.pixels < kHelped * left.pixels) ||
                 (errors.blocks() != Excess::kNone && now.blocks < kHelped * left.blocks);
    left = now;
  }
  const Mending mixed = mix_paths(measure);
  return mixed == Mending::kNone && attempts > 0 ? Mending::kGood : mixed;
}

/// By what this frame errs on average with those before, as it alone knows little.
std::optional<PathMix> CachedFrame::mix_wanted(const GatherMeasure& measure, double share_of_rays) const {
  const FrameError may = measure.goal(), &found = history_.errors.found(), &allowed = history_.errors.allowed();
  const FrameError mixed{found.pixels / allowed.pixels * may.pixels, found.blocks / allowed.blocks * may.blocks};
  return measure.mix_for(measure.without(history_.plan->mix, mixed), share_of_rays);
}

/// For the next frame: one that needs paths may have had bad luck, two in a row have not.
void CachedFrame::adjust_mix(const GatherMeasure& measure, bool was_mixed) {
  PathMix& mix = history_.plan->mix;
  const bool had_to_mix = std::exchange(history_.has_to_mix, mix.samples > 0);
  if (!was_mixed && !had_to_mix) mix = {};
  if (mix.samples == 0) return;
  const std::optional<PathMix> wanted = mix_wanted(measure, 0.0);
  const float more = wanted ? static_cast<float>(wanted->samples) / static_cast<float>(mix.samples) : kMorePaths;
  mix = scaled(mix, std::clamp(more, 1.0f / kMorePaths, kMorePaths), params_.spp);
}

/// The share of a whole frame's rays that count where paths are mixed in. A history's first frame counts only what gathering it
/// anew takes, as a still has nothing else to lose.
double CachedFrame::share_before_mixing(const GatherMeasure& measure) const {
  const auto share = [&](std::uint64_t rays) { return static_cast<double>(rays) / measure.rays_of_whole_frame(); };
  if (moved_) return share(counts_.total() + rays_of_gather_);
  return share(rays_of_gather_) - static_cast<double>(history_.plan->mix.samples) / params_.spp;
}

/// What is still wrong averages out with that of a few paths.
CachedFrame::Mending CachedFrame::mix_paths(const GatherMeasure& measure) {
  const FrameErrors& errors = history_.errors;
  if (!errors.is_too_large()) return Mending::kNone;
  const std::optional<PathMix> mix = mix_wanted(measure, share_before_mixing(measure));
  if (!mix) return moved_ || is_far_off(errors.latest(), measure.goal()) ? Mending::kFailed : Mending::kNone;
  history_.plan->mix = *mix;
  return Mending::kGood;
}

/// Samples of a cell at most that a frame is updated for.
constexpr float kMostPerCell = 256.0f;

/// Light that is wrong shows in pixels and in means.
void CachedFrame::update_more(int attempt) {
  history_.enough = std::min(2.0f * history_.enough, std::max(kMostPerCell, history_.mean));
  enough_ = std::max(enough_, history_.enough);
  const CacheCells in = cells();
  const UpdateTarget target{in, *history_.cache, pool_, context_, moved_ ? &*moved_ : nullptr};
  const int first = round_;
  round_ += 2 * kRoundsPerFrame << attempt;
  const UpdateRound made = updater_.update(target, first);
  add(made.rays, counts_);
  PacketGroups sparse;
  add_sparse_groups(made, *history_.cache, enough_, sparse);
  update_sparse(target, std::move(sparse), first + 1, round_);
  history_.cache->resolve(pool_);
}

void CachedFrame::start_cache(float samples_per_cell, LightGroup lights_from) {
  if (history_.cache && samples_per_cell == history_.samples_per_cell && lights_from == history_.lights_from) return;
  const Vec2i film = film_size(shot_.optics);
  const double pixels = static_cast<double>(film.x) * static_cast<double>(film.y);
  history_.cache.emplace(static_cast<std::size_t>(std::max(kCellsPerPixel * pixels, kLeastCells)));
  history_.samples_per_cell = samples_per_cell, history_.lights_from = lights_from;
  round_ = 0, records_ = 0, rays_of_cache_ = 0, update_seconds_ = 0.0;
}

/// Samples that cells have, on average.
double CachedFrame::samples_per_cell() const {
  return static_cast<double>(records_) / static_cast<double>(std::max<std::size_t>(history_.cache->cells(), 1));
}

/// Samples across the smallest cells that fit (kLeastPerCell).
float CachedFrame::fitting_cell() {
  start_cache(kLargestCell, CacheSetup{}.lights_from);
  update(1);
  float cell = kLargestCell;
  double per_cell = kRoundsPerFrame * samples_per_cell();
  for (; cell > kSmallestCell && per_cell >= 4.0 * kLeastPerCell; per_cell /= 4.0) cell /= 2.0f;
  return cell;
}

void CachedFrame::set_up(const CacheSetup& setup, float fitting_cell) {
  start_cache(setup.cell * fitting_cell, setup.lights_from);
  update(setup.rounds - round_);
  history_.cache->resolve(pool_);
  history_.rounds = round_;
  const auto mean = static_cast<float>(samples_per_cell());
  history_.mean = mean;
  history_.enough = std::max(kEnough * mean, std::min(kWanted * mean, kMostWanted));
}

void CachedFrame::begin_history(const CachedLightGoal& goal) {
  GatherMeasure measure = this->measure(goal, kPlanning);
  const float fitting = fitting_cell();
  const LightTable& lights = *shot_.device.shaded().path->lights;
  SetupSearch search(lights.chance(kLamps) > 0.0f, lights.chance(kSkyLight) > 0.0f);
  const double frames = goal.frames;
  const double most_rays = most_spent(goal.frames) * measure.rays_of_whole_frame();
  std::optional<GatherPlan> good;
  std::optional<MixedSetup> mixed;
  std::optional<GatherMeasure> fresh;
  for (bool goes_on = true; goes_on && !context_.cancelled;) {
    set_up(search.current(), fitting);
    SetupOutcome outcome = try_setup(goal, measure);
    if (outcome.is_good && !goal.seconds) {
      if (!fresh) fresh.emplace(this->measure(goal, kConfirming));
      confirm(outcome, measure.goal(), *fresh);
    }
    if (outcome.is_good) good = history_.plan;
    const double spent =
        static_cast<double>(counts_.total() + measure.counts().total() + (fresh ? fresh->counts().total() : 0));
    if (!outcome.is_good && history_.plan) keep_mixed(measure, search.current(), mixed);
    const double otherwise = frames * (mixed ? mixed->plan.share_of_rays : 1.0) * measure.rays_of_whole_frame();
    const double going_on = frames * measure.share_of_last() * measure.rays_of_whole_frame() + rays_until_good(outcome);
    goes_on = search.go_on(outcome) && (goal.seconds || (spent < most_rays && going_on < otherwise));
  }
  if (fresh) add(fresh->counts(), counts_);
  if (!goal.seconds) history_.plan = good ? good : mixed ? std::optional(mixed->plan) : std::nullopt;
  if (history_.plan && !goal.seconds && !context_.cancelled) {
    set_up(good ? *search.good() : mixed->setup, fitting);
    const CacheCells in = cells();
    measure.plan_frames_in_a_row({shot_, in, *history_.cache}, *history_.plan);
  }
  history_.least = history_.plan ? history_.plan->effort() : GatherEffort{};
  history_.path_samples = path_samples(goal, params_.spp, measure.of_paths());
  add(measure.counts(), counts_);
  rays_of_search_ = counts_.total();
}

/// Keeps, among setups that are not good enough, the one that needs the fewest rays once paths are mixed in.
void CachedFrame::keep_mixed(const GatherMeasure& measure, const CacheSetup& setup, std::optional<MixedSetup>& best) const {
  MixedSetup now{setup, *history_.plan};
  const std::optional<PathMix> mix = measure.mix_for(now.plan.expected, now.plan.share_of_rays);
  if (!mix) return;
  now.plan.mix = *mix;
  now.plan.share_of_rays += static_cast<double>(mix->samples) / params_.spp;
  if (!best || now.plan.share_of_rays < best->plan.share_of_rays) best = now;
}

/// What frames from the cache as it is now err by, and the plan for them.
SetupOutcome CachedFrame::try_setup(const CachedLightGoal& goal, GatherMeasure& measure) {
  const CacheCells in = cells();
  const GatherSources sources{shot_, in, *history_.cache};
  SetupOutcome outcome;
  if (goal.seconds) {
    const GatherMeasure::Timed found = measure.plan_within(sources, seconds_for_pixels(*goal.seconds));
    history_.plan = found.plan;
    outcome.is_good = found.is_spent;  // else frames get better by what takes longer to begin with
    outcome.excess = found.plan.expected.pixels;
    return outcome;
  }
  history_.plan = measure.plan(sources);
  const FrameError& left = history_.plan ? history_.plan->expected : measure.last();
  outcome.excess = std::max(left.pixels / measure.goal().pixels, left.blocks / measure.goal().blocks);
  outcome.is_good = history_.plan && left.pixels <= measure.goal().pixels && left.blocks <= measure.goal().blocks;
  outcome.of_cells = history_.plan ? history_.plan->of_cells : 1.0f;
  return outcome;
}

/// What updates may still take until frames are good, if cells are all that is wrong.
double CachedFrame::rays_until_good(const SetupOutcome& outcome) const {
  const double more = std::pow(std::max(static_cast<double>(outcome.excess), 1.0), kUpdatesPerExcess) - 1.0;
  return more * static_cast<double>(rays_of_cache_);
}

/// Among many setups one is good by chance where it was tried: only what is good elsewhere, too, is taken.
void CachedFrame::confirm(SetupOutcome& outcome, const FrameError& may, GatherMeasure& fresh) {
  const CacheCells in = cells();
  const FrameError found = fresh.check({shot_, in, *history_.cache}, history_.plan->effort_alone(), {});
  FrameError& expected = history_.plan->expected;
  expected.pixels = std::max(expected.pixels, found.pixels), expected.blocks = std::max(expected.blocks, found.blocks);
  outcome.excess = std::max({outcome.excess, found.pixels / may.pixels, found.blocks / may.blocks});
  outcome.is_good = found.pixels - found.uncertainty <= may.pixels && found.blocks - found.block_uncertainty <= may.blocks;
}

/// What a round of updates leaves of a frame's seconds.
double CachedFrame::seconds_for_pixels(double seconds) const {
  constexpr double kLeastShare = 0.2;
  return std::max(kLeastShare * seconds, seconds - update_seconds_ / std::max(round_, 1));
}

void CachedFrame::gather(bool provenance, const CachedLightPictures& pictures) {
  const CacheCells in = cells();
  const GatherSources sources{shot_, in, *history_.cache};
  Image* const alpha = alpha_of(pictures);
  if (alpha) pictures.aovs->allocate(Aov::kAlpha, film_size(shot_.optics));
  const RayCounts rays = gather_frame(sources, {params_, effort(), provenance}, {}, {&before_, &history_.scatter, &expected_},
                                      {pool_, context_}, {pictures.film, alpha, pictures.noisy});
  add(rays, counts_);
  rays_of_gather_ = rays.total();
}

/// Paths, as many as the goal is known to take; where these fall short, the frames after have more.
void CachedFrame::make_traced(const CachedLightGoal& goal, const CachedLightPictures& pictures) {
  TraceParams whole = params_;
  whole.spp = history_.path_samples;
  add(trace_whole(whole, pictures), counts_);
  if (context_.cancelled) return;
  const FrameError found = measure_traced(whole, !alpha_of(pictures), pictures.film);
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
  if (!goal.squared_error) return samples;
  return path_samples_for(*goal.squared_error, samples, found, kMostMorePaths * params_.spp);
}

/// shows_all: the surroundings, too, as the paths do that it is compared with.
FrameError CachedFrame::measure_traced(const TraceParams& whole, bool shows_all, const Image& film) {
  MeasuredPixels where = choose_pixels(film, kWatching, {}, hash(params_.seed, params_.frame));
  const PixelMeasure measure(shot_, whole, std::move(where), shows_all ? 1 : 2, pool_);
  add(measure.counts(), counts_);
  const PixelError pixels = shows_all ? measure.of_paths(film) : measure.of_paths();
  // Errors of paths have nothing to do with each other, from pixel to pixel.
  return {pixels.squared, pixels.squared / kBlockPixels, pixels.uncertainty, pixels.uncertainty / kBlockPixels};
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

double CachedLightTracer::bytes_per_pixel() {
  return kCellsPerPixel * static_cast<double>(RadianceCache::bytes_per_cell()) + 2.0 * sizeof(float);
}

CachedLightReport CachedLightTracer::trace(const Shot& shot, const ResolvedScene& resolved, const TraceParams& params,
                                           const CachedLightGoal& goal, const std::vector<HorizonBox>& moving,
                                           const Workers& workers, const CachedLightPictures& pictures) {
  History& history = impl_->history;
  impl_->places.update(resolved);
  CachedFrame frame(shot, impl_->places, params, workers, history);
  if (!history.cache)
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
  const FrameError& error = report.traced ? history.path_errors.found() : history.errors.found();
  const PixelError& of_pixels = (report.traced ? history.path_errors : history.errors).of_latest();
  report.squared_error = static_cast<double>(of_pixels.squared),
  report.uncertainty = static_cast<double>(of_pixels.uncertainty);
  report.block_squared_error = static_cast<double>(error.blocks);
  report.rays = frame.counts();
  return report;
}

}  // namespace lippmann
