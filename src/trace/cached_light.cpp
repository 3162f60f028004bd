#include "trace/cached_light.hpp"

#include <array>

#include "core/random.hpp"
#include "trace/gather_error.hpp"
#include "trace/packet_source.hpp"

namespace lippmann {
namespace {

/// Each round of feeding follows a ray of every fourth packet.
constexpr int kRounds = 4;

/// How a history may begin: samples across the smallest cells, and rounds of feeding. The first that is good enough is kept:
/// more light where cells are too noisy, smaller ones where they blur.
struct Beginning {
  float samples_per_cell;
  int rounds;
};
constexpr std::array<Beginning, 5> kBeginnings{{{8, 4}, {8, 16}, {4, 16}, {4, 48}, {2, 48}}};
/// Frames after the first feed a sixteenth as much, but at least one round.
constexpr int kRoundsOfFirst = 16;

/// The cache grows to so many cells; smooth scenes need 0.1 to 0.2 of a pixel's, leaves of a pixel's size 0.5.
constexpr double kCellsPerPixel = 1.0;
constexpr double kLeastCells = 65536.0;
/// Sub-pixel places that these rays take in turn.
constexpr int kPlaces = 16;

/// What frames since restart() have found.
struct History {
  std::optional<LightCache> cache;  ///< none: no frame yet
  float samples_per_cell = 0.0f;    ///< of LightCells, since the first frame
  int rounds = 1;                   ///< of feeding a frame, likewise
  std::optional<GatherPlan> plan;   ///< likewise; none: frames are traced, with
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
        beam_(optics, world_from_display),
        source_(optics, world_from_display, params.order, SubPixel{params.seed, kPlaces, AngularFilter::kNone}) {}

  void begin_history(const CachedLightGoal& goal);
  void go_on() {
    history_.cache->begin_frame(pool_);
    feed(history_.rounds);
  }
  void gather(bool provenance, Image& film);
  void trace_whole(Image& film);

  const RayCounts& counts() const { return counts_; }

 private:
  void feed(int rounds);
  std::vector<LightRecord> feed_strip(std::size_t strip, int round, RayCounts& counts) const;
  LightCells cells() const { return {places_, beam_, history_.samples_per_cell}; }

  const DeviceScene& device_;
  const SurfacePlaces& places_;
  const Optics& optics_;
  const Affine3f& world_from_display_;
  const TraceParams& params_;
  const ThreadPool& pool_;
  const Context& context_;
  History& history_;
  BeamFootprint beam_;
  PacketSource source_;
  int round_ = 0;  ///< of feeding
  RayCounts counts_;
};

/// Rounds from kRounds on follow other rays of the same packets.
std::vector<LightRecord> CachedFrame::feed_strip(std::size_t strip, int round, RayCounts& counts) const {
  const auto seed = static_cast<std::uint32_t>(round);
  const PathParams paths{params_.max_depth, hash(params_.seed, params_.frame, 0x6c696768u + seed), params_.clamp_indirect};
  const int place = static_cast<int>(hash(params_.seed, params_.frame, seed) % kPlaces);
  const int first = static_cast<int>((params_.frame + seed) % kRounds);
  std::vector<LightRecord> records;
  const LightCells in = cells();
  LightFeeder feeder(device_.impl(), in, paths);
  RayHitPacket packet;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  auto group = static_cast<std::uint32_t>(strip) << 16;
  feeder.begin_group(group);
  int waiting = 0;
  for (int p = first; p < source_.packets_per_strip(); p += kRounds) {
    if (source_.fill(static_cast<int>(strip), p, place, packet.ray, active, pixel) == 0) continue;
    feeder.primary(packet, active, pixel);
    if (++waiting < kPacketsPerBlock) continue;
    feeder.finish_group(records);
    feeder.begin_group(++group);
    waiting = 0;
  }
  feeder.finish_group(records);
  counts = feeder.counts();
  return records;
}

void CachedFrame::feed(int rounds) {
  const auto strips = static_cast<std::size_t>(source_.strips());
  for (const int end = round_ + rounds; round_ < end && !context_.cancelled; ++round_) {
    std::vector<std::vector<LightRecord>> records(strips);
    std::vector<RayCounts> counts(strips);
    pool_.for_each(strips, [&](std::size_t strip) {
      if (!context_.cancelled) records[strip] = feed_strip(strip, round_, counts[strip]);
    });
    history_.cache->add(records, pool_);
    for (const RayCounts& c : counts) add(c, counts_);
  }
  history_.cache->resolve(pool_);
}

void CachedFrame::begin_history(const CachedLightGoal& goal) {
  GatherMeasure measure(device_, optics_, world_from_display_, params_, goal.squared_error, pool_);
  history_.plan.reset();
  for (const Beginning& beginning : kBeginnings) {
    if (context_.cancelled || history_.plan) break;
    if (!history_.cache || beginning.samples_per_cell != history_.samples_per_cell) {
      const double pixels = static_cast<double>(optics_.panel.width) * static_cast<double>(optics_.panel.height);
      history_.cache.emplace(static_cast<std::size_t>(std::max(kCellsPerPixel * pixels, kLeastCells)));
      history_.samples_per_cell = beginning.samples_per_cell;
      round_ = 0;
    }
    feed(beginning.rounds - round_);
    history_.rounds = std::max(1, beginning.rounds / kRoundsOfFirst);
    const LightCells in = cells();
    history_.plan = measure.plan({device_.impl(), in, *history_.cache, optics_, world_from_display_});
  }
  history_.squared_goal = measure.squared_goal();
  history_.path_samples = measure.path_samples();
  add(measure.counts(), counts_);
}

void CachedFrame::gather(bool provenance, Image& film) {
  if (!history_.scatter.empty()) history_.scatter = widened(history_.scatter, optics_, pool_);
  Scatter now;
  const LightCells in = cells();
  const GatherSources sources{device_.impl(), in, *history_.cache, optics_, world_from_display_};
  add(gather_frame(sources, {params_, history_.plan->error, provenance}, {}, {&history_.scatter, &now}, pool_, context_, film),
      counts_);
  history_.scatter = std::move(now);
}

void CachedFrame::trace_whole(Image& film) {
  TraceParams whole = params_;
  whole.spp = history_.path_samples;
  add(trace_frame(device_, optics_, world_from_display_, whole, pool_, context_, film), counts_);
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
                                           Image& film) {
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
  if (!context.cancelled) {
    if (report.traced)
      frame.trace_whole(film);
    else
      frame.gather(goal.provenance, film);
  }
  report.rays = frame.counts();
  return report;
}

}  // namespace lippmann
