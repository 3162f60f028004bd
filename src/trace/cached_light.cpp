#include "trace/cached_light.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include "core/random.hpp"
#include "trace/feed_frame.hpp"
#include "trace/gather_error.hpp"

namespace lippmann {
namespace {

/// How a history may begin: samples across the smallest cells, in parts of what fits; rounds of feeding; the lights that the
/// cache holds (LightCells), of which a sun is never one. The first that is good enough is kept: more light where cells are too
/// noisy, lamps and then the sky asked at every point where cells blur their shadows, smaller ones where it is other light that
/// they blur.
struct Beginning {
  float cell;
  int rounds;
  LightGroup lights_from;
  float of_cells;  ///< share of the error that cells may make: where it is more, the next beginning's feeding saves more
                   ///< samples than it costs
};
constexpr std::array<Beginning, 8> kBeginnings{{{1.0f, 4, LightGroup::kLamps, 0.4f},
                                                {1.0f, 8, LightGroup::kLamps, 0.7f},
                                                {1.0f, 16, LightGroup::kLamps, 1.0f},
                                                {1.0f, 4, LightGroup::kSky, 1.0f},
                                                {1.0f, 4, LightGroup::kEnd, 1.0f},
                                                {0.5f, 16, LightGroup::kLamps, 1.0f},
                                                {0.5f, 48, LightGroup::kLamps, 1.0f},
                                                {0.25f, 48, LightGroup::kLamps, 1.0f}}};
/// Cells fit that are as small as the light fed to begin with allows: the more pixels see a place, the smaller.
constexpr float kLargestCell = 8.0f, kSmallestCell = 2.0f;
constexpr double kLeastPerCell = 8.0;

/// Of the samples that the first frame's feeding gave cells on average: cells with less are fed as often again, in every frame.
/// More than once, as what moves and what changes forgets: with less, frames get worse from the first on. But more than once no
/// more than kPlenty.
constexpr float kScarce = 4.0f, kPlenty = 48.0f;

/// Textures are filtered as of so many samples a pixel: wider, and they blur what paths show sharply; narrower, and pixels need
/// more samples.
constexpr int kTextureSamples = 16;

/// The cache grows to so many cells; smooth scenes need 0.1 to 0.2 of a pixel's, leaves of a pixel's size 0.5.
constexpr double kCellsPerPixel = 1.0;
constexpr double kLeastCells = 65536.0;

/// What frames since restart() have found.
struct History {
  std::optional<LightCache> cache;  ///< none: no frame yet
  float samples_per_cell = 0.0f;    ///< of LightCells, since the first frame
  LightGroup lights_from{};         ///< likewise
  int rounds = 0;                   ///< of feeding the first frame
  float enough = 0.0f;              ///< samples of a cell (kScarce)
  std::optional<GatherPlan> plan;   ///< since the first frame; none: frames are traced, with
  int path_samples = 1;             ///< so many paths a pixel
  float squared_goal = 0.0f;        ///< mean squared error that frames may have
  Scatter scatter;                  ///< of the frame before, where it was gathered
};

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
  void go_on();
  void gather(bool provenance, Image& film, FrameAovs& aovs);
  void trace_whole(Image& film, FrameAovs& aovs);

  const RayCounts& counts() const { return counts_; }

 private:
  double seconds_for_pixels(double seconds) const;
  void begin(const Beginning& beginning, float fitting_cell);
  bool helps(const Beginning& beginning) const;
  void start_cache(float samples_per_cell, LightGroup lights_from);
  double samples_per_cell() const;
  float fitting_cell();
  void feed(int rounds);
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
  int round_ = 0;  ///< of feeding
  double feeding_seconds_ = 0.0;
  std::size_t records_ = 0;  ///< fed since start_cache()
  RayCounts counts_;
};

void CachedFrame::feed(int rounds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const LightCells in = cells();
  for (const int end = round_ + rounds; round_ < end && !context_.cancelled; ++round_) {
    const Fed fed = feeder_.feed({in, *history_.cache, pool_, context_}, round_);
    add(fed.rays, counts_);
    records_ += fed.records;
  }
  feeding_seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
}

/// A little everywhere, and as much as the first frame was given where little is known: what was hidden before, and what has
/// changed.
void CachedFrame::go_on() {
  history_.cache->begin_frame([this](std::uint32_t thing, Vec3f at) { return places_.moved(thing, at); }, pool_);
  const LightCells in = cells();
  const FeedTarget target{in, *history_.cache, pool_, context_};
  PacketGroups scarce;
  add(feeder_.feed(target, 0, history_.enough, scarce).rays, counts_);
  PacketGroups still(scarce.size());
  for (int round = 1; round < history_.rounds && !context_.cancelled; ++round) {
    add(feeder_.feed_scarce(target, round, history_.enough, scarce, still).rays, counts_);
    if (round % kRoundsPerFrame == 0) {  // all packets of a group have had their turn
      for (std::vector<std::uint32_t>& groups : still) {
        std::sort(groups.begin(), groups.end());
        groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
      }
      scarce = std::move(still);
      still.assign(scarce.size(), {});
    }
  }
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
  start_cache(kLargestCell, kBeginnings[0].lights_from);
  feed(1);
  float cell = kLargestCell;
  double per_cell = kRoundsPerFrame * samples_per_cell();
  for (; cell > kSmallestCell && per_cell >= 4.0 * kLeastPerCell; per_cell /= 4.0) cell /= 2.0f;
  return cell;
}

/// To ask lamps or the sky at every point, there must be some: else another beginning asks for as much.
bool CachedFrame::helps(const Beginning& beginning) const {
  const LightTable& lights = *device_.impl().path->lights;
  if (beginning.lights_from == LightGroup::kSky) return lights.chance(kLamps) > 0.0f;
  if (beginning.lights_from == LightGroup::kEnd) return lights.chance(kSkyLight) > 0.0f;
  return true;
}

void CachedFrame::begin(const Beginning& beginning, float fitting_cell) {
  start_cache(beginning.cell * fitting_cell, beginning.lights_from);
  feed(beginning.rounds - round_);
  history_.cache->resolve(pool_);
  history_.rounds = round_;
  const auto mean = static_cast<float>(samples_per_cell());
  history_.enough = std::max(mean, std::min(kScarce * mean, kPlenty));
}

void CachedFrame::begin_history(const CachedLightGoal& goal) {
  GatherMeasure measure(device_, optics_, world_from_display_, params_, goal.squared_error, pool_);
  const float fitting = fitting_cell();
  history_.plan.reset();
  bool is_done = false;
  for (const Beginning& beginning : kBeginnings) {
    if (context_.cancelled || is_done) break;
    if (!helps(beginning)) continue;
    begin(beginning, fitting);
    const LightCells in = cells();
    const GatherSources sources{device_.impl(), in, *history_.cache, optics_, world_from_display_};
    if (goal.seconds) {
      const GatherMeasure::Timed found = measure.plan_within(sources, seconds_for_pixels(*goal.seconds));
      history_.plan = found.plan;
      is_done = found.is_spent;  // else frames get better by what takes longer to begin with
    } else {
      if (const std::optional<GatherPlan> found = measure.plan(sources)) history_.plan = found;
      is_done = history_.plan && history_.plan->of_cells <= beginning.of_cells;
    }
  }
  if (history_.plan && !goal.seconds && !context_.cancelled) {
    const LightCells in = cells();
    measure.plan_frames_in_a_row({device_.impl(), in, *history_.cache, optics_, world_from_display_}, *history_.plan);
  }
  history_.squared_goal = measure.squared_goal();
  history_.path_samples = measure.path_samples();
  add(measure.counts(), counts_);
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
                                           const CachedLightGoal& goal, const ThreadPool& pool, const Context& context,
                                           Image& film, FrameAovs* aovs) {
  History& history = impl_->history;
  impl_->places.update(resolved);
  CachedFrame frame(impl_->device, impl_->places, optics, world_from_display, params, pool, context, history);
  if (!history.cache)
    frame.begin_history(goal);
  else if (history.plan)
    frame.go_on();
  CachedLightReport report;
  report.traced = !history.plan;
  report.squared_error = static_cast<double>(report.traced ? history.squared_goal : history.plan->squared_error);
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
