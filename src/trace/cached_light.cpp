#include "trace/cached_light.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "trace/feed_frame.hpp"
#include "trace/frame_errors.hpp"
#include "trace/light_beginnings.hpp"

namespace lippmann {
namespace {

/// Cells fit that are as small as the light fed to begin with allows: the more pixels see a place, the smaller.
constexpr float kLargestCell = 8.0f, kSmallestCell = 2.0f;
constexpr double kLeastPerCell = 8.0;

/// Of the samples that the first frame's feeding gave cells on average: cells with less are fed as often again, in every frame.
/// More than once, as what moves and what changes forgets: with less, frames get worse from the first on. But more than once no
/// more than kPlenty.
constexpr float kScarce = 4.0f, kPlenty = 96.0f, kMost = 0.8f;

/// Textures are filtered as of so many samples a pixel: wider, and they blur what paths show sharply; narrower, and pixels need
/// more samples.
constexpr int kTextureSamples = 16;

/// The cache grows to so many cells; smooth scenes need 0.1 to 0.2 of a pixel's, leaves of a pixel's size 0.5.
constexpr double kCellsPerPixel = 1.0;
constexpr double kLeastCells = 65536.0;

/// Rays of a whole frame that may be spent to find out how to begin, and that it is better to trace paths: a part of what the
/// history can save.
double most_spent(int frames) { return std::clamp(0.04 * frames, 0.3, 0.65); }

/// What frames since restart() have found.
struct History {
  std::optional<LightCache> cache;  ///< none: no frame yet
  float samples_per_cell = 0.0f;    ///< of LightCells, since the first frame
  LightGroup lights_from{};         ///< likewise
  int rounds = 0;                   ///< of feeding the first frame
  float mean = 0.0f;                ///< samples of a cell that it gave
  float enough = 0.0f;              ///< samples of a cell (kScarce)
  std::optional<GatherPlan> plan;   ///< since the first frame; none: frames are traced, with
  int path_samples = 1;             ///< so many paths a pixel
  float coarsest_error = 0.0f;      ///< of the plan, as it was made
  FrameErrors errors;
  int failures = 0;  ///< frames in a row that had to be traced
  Scatter scatter;   ///< of the frame before, where it was gathered
};

/// Of the error that a sample may have, where a frame errs by too much.
constexpr float kFiner = 0.75f;
/// Where pixels err by less than this part of what they may, they need not be sampled as finely.
constexpr float kSpare = 0.6f;
/// How often a frame is given more light and more samples before it is traced.
constexpr int kAttempts = 2;
/// An error so many times as large as it may be is more than that makes up for.
constexpr float kHopeless = 6.0f;
/// Of the error before: an attempt that leaves more has not helped.
constexpr float kHelped = 0.9f;
/// After so many frames in a row that had to be traced, the others of the history are, too.
constexpr int kMostFailures = 2;

/// One frame on its way.
class CachedFrame {
 public:
  CachedFrame(const DeviceScene& device, const SurfacePlaces& places, const Optics& optics, const Affine3f& world_from_display,
              const TraceParams& params, const ThreadPool& pool, const Context& context, History& history)
      : device_(device),
        places_(places),
        optics_(optics),
        world_from_display_(world_from_display),
        params_(params),
        pool_(pool),
        context_(context),
        history_(history),
        beam_(optics, world_from_display, kTextureSamples),
        feeder_(device.impl(), optics, world_from_display, params) {}

  void begin_history(const CachedLightGoal& goal);
  void go_on(const CachedLightGoal& goal, const std::vector<HorizonBox>& moving);
  void gather(bool provenance, Image& film, FrameAovs& aovs);
  void trace_whole(Image& film, FrameAovs& aovs);

  bool is_short() const { return is_short_; }
  const RayCounts& counts() const { return counts_; }

 private:
  double seconds_for_pixels(double seconds) const;
  void begin(const Beginning& beginning, float fitting_cell);
  BeginningOutcome try_beginning(const CachedLightGoal& goal, GatherMeasure& measure);
  void start_cache(float samples_per_cell, LightGroup lights_from);
  double samples_per_cell() const;
  float fitting_cell();
  void feed(int rounds);
  bool check(const CachedLightGoal& goal, const TouchProbe& moved);
  void feed_more(int attempt, const TouchProbe& moved);
  void feed_scarce(const FeedTarget& target, PacketGroups scarce, int first_round, int end);
  LightCells cells() const { return {places_, beam_, history_.samples_per_cell, history_.lights_from}; }

  const DeviceScene& device_;
  const SurfacePlaces& places_;
  const Optics& optics_;
  const Affine3f& world_from_display_;
  const TraceParams& params_;
  const ThreadPool& pool_;
  const Context& context_;
  History& history_;
  BeamFootprint beam_;
  FrameFeeder feeder_;
  int round_ = 0;        ///< of feeding
  float enough_ = 0.0f;  ///< samples of a cell, in this frame
  double feeding_seconds_ = 0.0;
  std::size_t records_ = 0;  ///< fed since start_cache()
  bool is_short_ = false;    ///< errs by more than it may, whatever was done
  RayCounts counts_;
};

void CachedFrame::feed(int rounds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const LightCells in = cells();
  for (const int end = round_ + rounds; round_ < end && !context_.cancelled; ++round_) {
    const Fed fed = feeder_.feed({in, *history_.cache, pool_, context_}, round_);
    add(fed.rays, counts_);
    records_ += fed.records();
  }
  feeding_seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
}

/// A little everywhere, and as much as the first frame was given where little is known: what was hidden before, and what has
/// changed; then whatever it takes.
void CachedFrame::go_on(const CachedLightGoal& goal, const std::vector<HorizonBox>& moving) {
  LightCache& cache = *history_.cache;
  cache.begin_frame([this](std::uint32_t thing, Vec3f at) { return places_.moved(thing, at); }, pool_);
  const LightCells in = cells();
  const TouchProbe moved(device_.impl().device.get(), device_.impl().native_width, moving);
  const FeedTarget target{in, cache, pool_, context_, &moved};
  const Fed everywhere = feeder_.feed(target, 0);
  add(everywhere.rays, counts_);
  // The more is forgotten, the more has to be fed as in the first frame.
  const float lost = cache.forget(pool_);
  enough_ = std::max(history_.enough, lost * history_.mean);
  PacketGroups scarce;
  add_scarce_groups(everywhere, cache, enough_, scarce);
  feed_scarce(target, std::move(scarce), 1, history_.rounds);
  cache.resolve(pool_);
  round_ = history_.rounds;
  is_short_ = !check(goal, moved);
}

/// Rounds of groups that have met scarce cells, until there are none any more.
void CachedFrame::feed_scarce(const FeedTarget& target, PacketGroups scarce, int first_round, int end) {
  PacketGroups still;
  for (int round = first_round; round < end && !context_.cancelled; ++round) {
    const Fed fed = feeder_.feed_scarce(target, round, enough_, scarce);
    add(fed.rays, counts_);
    add_scarce_groups(fed, target.cache, enough_, still);
    if (round % kRoundsPerFrame == 0) {  // all packets of a group have had their turn
      target.cache.forget(pool_);
      scarce = std::exchange(still, {});
    }
  }
  target.cache.forget(pool_);
}

/// Whether this frame errs by no more than it may; else it is given more light and more samples, as often as may help.
bool CachedFrame::check(const CachedLightGoal& goal, const TouchProbe& moved) {
  const Scatter before = smoothed(history_.scatter, optics_, pool_);
  GatherMeasure measure(device_, optics_, world_from_display_, params_, goal.squared_error, kChecking, before, pool_);
  const LightCells in = cells();
  const GatherSources sources{device_.impl(), in, *history_.cache, optics_, world_from_display_};
  const FrameErrors former = history_.errors;
  if (former.found().pixels < kSpare * former.allowed().pixels)
    history_.plan->error = std::min(history_.plan->error / kFiner, history_.coarsest_error);
  FrameError attempted;  // what the last attempt has left
  bool is_short = false;
  for (int attempt = 0; !context_.cancelled; ++attempt) {
    float& error = before.empty() ? history_.plan->error_alone : history_.plan->error;
    const FrameError now = measure.check(sources, error, before), may = measure.goal();
    history_.errors = former;
    history_.errors.add(now, may);
    const FrameErrors& errors = history_.errors;
    is_short = errors.pixels() == Excess::kSure || errors.blocks() == Excess::kSure;
    const bool has_helped = attempt == 0 || (errors.pixels() != Excess::kNone && now.pixels < kHelped * attempted.pixels) ||
                            (errors.blocks() != Excess::kNone && now.blocks < kHelped * attempted.blocks);
    const bool is_good = errors.pixels() == Excess::kNone && errors.blocks() == Excess::kNone;
    const bool is_hopeless = now.pixels > kHopeless * may.pixels || now.blocks > kHopeless * may.blocks;
    if (is_good || is_hopeless || attempt == kAttempts || !has_helped || goal.seconds) break;
    attempted = now;
    error *= kFiner;
    feed_more(attempt, moved);
  }
  add(measure.counts(), counts_);
  return !is_short || goal.seconds;
}

/// Samples of a cell at most that a frame is fed for.
constexpr float kMostPerCell = 256.0f;

/// Light that is wrong shows in pixels and in means.
void CachedFrame::feed_more(int attempt, const TouchProbe& moved) {
  history_.enough = std::min(2.0f * history_.enough, std::max(kMostPerCell, history_.mean));
  enough_ = std::max(enough_, history_.enough);
  const LightCells in = cells();
  const FeedTarget target{in, *history_.cache, pool_, context_, &moved};
  const int first = round_;
  round_ += 2 * kRoundsPerFrame << attempt;
  const Fed fed = feeder_.feed(target, first);
  add(fed.rays, counts_);
  PacketGroups scarce;
  add_scarce_groups(fed, *history_.cache, enough_, scarce);
  feed_scarce(target, std::move(scarce), first + 1, round_);
  history_.cache->resolve(pool_);
}

void CachedFrame::start_cache(float samples_per_cell, LightGroup lights_from) {
  if (history_.cache && samples_per_cell == history_.samples_per_cell && lights_from == history_.lights_from) return;
  const double pixels = static_cast<double>(optics_.panel.width) * static_cast<double>(optics_.panel.height);
  history_.cache.emplace(static_cast<std::size_t>(std::max(kCellsPerPixel * pixels, kLeastCells)));
  history_.samples_per_cell = samples_per_cell, history_.lights_from = lights_from;
  round_ = 0, records_ = 0, feeding_seconds_ = 0.0;
}

/// What was fed, on average.
double CachedFrame::samples_per_cell() const {
  return static_cast<double>(records_) / static_cast<double>(std::max<std::size_t>(history_.cache->cells(), 1));
}

/// Samples across the smallest cells that fit (kLeastPerCell).
float CachedFrame::fitting_cell() {
  start_cache(kLargestCell, Beginning{}.lights_from);
  feed(1);
  float cell = kLargestCell;
  double per_cell = kRoundsPerFrame * samples_per_cell();
  for (; cell > kSmallestCell && per_cell >= 4.0 * kLeastPerCell; per_cell /= 4.0) cell /= 2.0f;
  return cell;
}

void CachedFrame::begin(const Beginning& beginning, float fitting_cell) {
  start_cache(beginning.cell * fitting_cell, beginning.lights_from);
  feed(beginning.rounds - round_);
  history_.cache->resolve(pool_);
  history_.rounds = round_;
  const auto mean = static_cast<float>(samples_per_cell());
  history_.mean = mean;
  history_.enough = std::max(kMost * mean, std::min(kScarce * mean, kPlenty));
}

void CachedFrame::begin_history(const CachedLightGoal& goal) {
  GatherMeasure measure(device_, optics_, world_from_display_, params_, goal.squared_error, kPlanning, {}, pool_);
  const float fitting = fitting_cell();
  const LightTable& lights = *device_.impl().path->lights;
  Beginnings beginnings(lights.chance(kLamps) > 0.0f, lights.chance(kSkyLight) > 0.0f);
  const double most_rays = most_spent(goal.frames) * measure.rays_of_whole_frame();
  std::optional<GatherPlan> good;
  for (bool goes_on = true; goes_on && !context_.cancelled;) {
    begin(beginnings.current(), fitting);
    const BeginningOutcome outcome = try_beginning(goal, measure);
    if (outcome.is_good) good = history_.plan;
    const double spent = static_cast<double>(counts_.total() + measure.counts().total());
    goes_on = beginnings.go_on(outcome) && (goal.seconds || spent < most_rays);
  }
  if (!goal.seconds) history_.plan = good;
  if (history_.plan && !goal.seconds && !context_.cancelled) {
    begin(*beginnings.good(), fitting);
    const LightCells in = cells();
    measure.plan_frames_in_a_row({device_.impl(), in, *history_.cache, optics_, world_from_display_}, *history_.plan);
  }
  history_.coarsest_error = history_.plan ? history_.plan->error : 0.0f;
  history_.errors = {};
  history_.errors.add(history_.plan ? history_.plan->expected : measure.goal(), measure.goal());
  history_.path_samples = measure.path_samples();
  add(measure.counts(), counts_);
}

/// What frames from the cache as it is now err by, and the plan for them.
BeginningOutcome CachedFrame::try_beginning(const CachedLightGoal& goal, GatherMeasure& measure) {
  const LightCells in = cells();
  const GatherSources sources{device_.impl(), in, *history_.cache, optics_, world_from_display_};
  BeginningOutcome outcome;
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
  outcome.is_good = history_.plan && left.blocks <= measure.goal().blocks;
  outcome.of_cells = history_.plan ? history_.plan->of_cells : 1.0f;
  return outcome;
}

/// Of a frame's, what a round of feeding leaves.
double CachedFrame::seconds_for_pixels(double seconds) const {
  constexpr double kLeastShare = 0.2;
  return std::max(kLeastShare * seconds, seconds - feeding_seconds_ / std::max(round_, 1));
}

void CachedFrame::gather(bool provenance, Image& film, FrameAovs& aovs) {
  const Scatter before = smoothed(history_.scatter, optics_, pool_);
  const LightCells in = cells();
  const GatherSources sources{device_.impl(), in, *history_.cache, optics_, world_from_display_};
  if (aovs.wants(Aov::kAlpha)) aovs.allocate(Aov::kAlpha, optics_.panel, 0.0f);
  Image* const alpha = aovs.wants(Aov::kAlpha) ? &aovs[Aov::kAlpha] : nullptr;
  const float error = before.empty() ? history_.plan->error_alone : history_.plan->error;
  add(gather_frame(sources, {params_, error, provenance}, {}, {&before, &history_.scatter}, pool_, context_, film, alpha),
      counts_);
}

void CachedFrame::trace_whole(Image& film, FrameAovs& aovs) {
  TraceParams whole = params_;
  whole.spp = history_.path_samples;
  add(trace_frame(device_, optics_, world_from_display_, whole, pool_, context_, film, &aovs), counts_);
}

}  // namespace

struct CachedLightTracer::Impl {
  explicit Impl(const DeviceScene& of) : device(of), places(of.impl()) {}

  const DeviceScene& device;
  SurfacePlaces places;
  History history;
};

CachedLightTracer::CachedLightTracer(const DeviceScene& scene) : impl_(std::make_unique<Impl>(scene)) {}

CachedLightTracer::~CachedLightTracer() = default;

void CachedLightTracer::restart() { impl_->history = {}; }

double CachedLightTracer::bytes_per_pixel() {
  return kCellsPerPixel * static_cast<double>(LightCache::bytes_per_cell()) + 2.0 * sizeof(float);
}

CachedLightReport CachedLightTracer::trace(const ResolvedScene& resolved, const Optics& optics,
                                           const Affine3f& world_from_display, const TraceParams& params,
                                           const CachedLightGoal& goal, const std::vector<HorizonBox>& moving,
                                           const ThreadPool& pool, const Context& context, Image& film, FrameAovs* aovs) {
  History& history = impl_->history;
  impl_->places.update(resolved);
  CachedFrame frame(impl_->device, impl_->places, optics, world_from_display, params, pool, context, history);
  if (!history.cache)
    frame.begin_history(goal);
  else if (history.plan)
    frame.go_on(goal, moving);
  history.failures = frame.is_short() ? history.failures + 1 : 0;
  if (history.failures >= kMostFailures) history.plan.reset();
  CachedLightReport report;
  report.traced = !history.plan || frame.is_short();
  const FrameError& error = report.traced ? history.errors.allowed() : history.errors.found();
  report.squared_error = static_cast<double>(error.pixels), report.block_squared_error = static_cast<double>(error.blocks);
  report.uncertainty = static_cast<double>(error.uncertainty);
  FrameAovs none;
  FrameAovs& layers = aovs ? *aovs : none;
  if (!context.cancelled) {
    if (report.traced)
      frame.trace_whole(film, layers);
    else
      frame.gather(goal.provenance, film, layers);
  }
  report.rays = frame.counts();
  return report;
}

}  // namespace lippmann
