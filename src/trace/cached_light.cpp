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

}  // namespace

struct CachedLightTracer::Impl {
  explicit Impl(const DeviceScene& of) : device(of), scene(of.impl()), places(scene) {}

  RayCounts feed(const LightCells& cells, const PacketSource& source, const TraceParams& params, int round,
                 const ThreadPool& pool, const Context& context);

  const DeviceScene& device;
  const DeviceScene::Impl& scene;
  SurfacePlaces places;
  std::optional<LightCache> cache;  ///< none: no frame yet
  float samples_per_cell = 0.0f;    ///< of LightCells, since the first frame
  int rounds = 1;                   ///< of feeding a frame, likewise
  std::optional<GatherPlan> plan;   ///< likewise; none: frames are traced, with
  int path_samples = 1;             ///< so many paths a pixel
  float squared_goal = 0.0f;        ///< mean squared error that frames may have
  Scatter scatter;                  ///< of the frame before, where it was gathered
};

/// One round of a frame's; rounds from kRounds on follow other rays of the same packets.
RayCounts CachedLightTracer::Impl::feed(const LightCells& cells, const PacketSource& source, const TraceParams& params,
                                        int round, const ThreadPool& pool, const Context& context) {
  const auto seed = static_cast<std::uint32_t>(round);
  const PathParams paths{params.max_depth, hash(params.seed, params.frame, 0x6c696768u + seed), params.clamp_indirect};
  const auto strips = static_cast<std::size_t>(source.strips());
  const int place = static_cast<int>(hash(params.seed, params.frame, seed) % kPlaces);
  const int first = static_cast<int>((params.frame + seed) % kRounds);
  std::vector<std::vector<LightRecord>> records(strips);
  std::vector<RayCounts> counts(strips);
  pool.for_each(strips, [&](std::size_t strip) {
    if (context.cancelled) return;
    LightFeeder feeder(scene, cells, paths);
    RayHitPacket packet;
    LaneMask active;
    alignas(64) std::uint32_t pixel[kLanes];
    auto group = static_cast<std::uint32_t>(strip) << 16;
    feeder.begin_group(group);
    int waiting = 0;
    for (int p = first; p < source.packets_per_strip(); p += kRounds) {
      if (source.fill(static_cast<int>(strip), p, place, packet.ray, active, pixel) == 0) continue;
      feeder.primary(packet, active, pixel);
      if (++waiting < kPacketsPerBlock) continue;
      feeder.finish_group(records[strip]);
      feeder.begin_group(++group);
      waiting = 0;
    }
    feeder.finish_group(records[strip]);
    counts[strip] = feeder.counts();
  });
  cache->add(records, pool);
  RayCounts total;
  for (const RayCounts& c : counts) add(c, total);
  return total;
}

CachedLightTracer::CachedLightTracer(const DeviceScene& scene) : impl_(std::make_unique<Impl>(scene)) {}

CachedLightTracer::~CachedLightTracer() = default;

void CachedLightTracer::restart() {
  impl_->cache.reset();
  impl_->scatter.clear();
}

double CachedLightTracer::bytes_per_pixel() {
  return kCellsPerPixel * static_cast<double>(LightCache::bytes_per_cell()) + 2.0 * sizeof(float);
}

CachedLightReport CachedLightTracer::trace(const ResolvedScene& resolved, const Optics& optics,
                                           const Affine3f& world_from_display, const TraceParams& params,
                                           const CachedLightGoal& goal, const ThreadPool& pool, const Context& context,
                                           Image& film) {
  Impl& impl = *impl_;
  CachedLightReport report;
  impl.places.update(resolved);
  const BeamFootprint beam(optics, world_from_display);
  const PacketSource source(optics, world_from_display, params.order, SubPixel{params.seed, kPlaces, AngularFilter::kNone});
  int round = 0;
  const auto feed = [&](int rounds) {
    const LightCells cells{impl.places, beam, impl.samples_per_cell};
    for (const int end = round + rounds; round < end && !context.cancelled; ++round)
      add(impl.feed(cells, source, params, round, pool, context), report.rays);
    impl.cache->resolve(pool);
  };
  if (!impl.cache) {
    GatherMeasure measure(impl.device, optics, world_from_display, params, goal.squared_error, pool);
    impl.plan.reset();
    for (const Beginning& beginning : kBeginnings) {
      if (impl.plan || context.cancelled) break;
      if (!impl.cache || beginning.samples_per_cell != impl.samples_per_cell) {
        const double pixels = static_cast<double>(optics.panel.width) * static_cast<double>(optics.panel.height);
        impl.cache.emplace(static_cast<std::size_t>(std::max(kCellsPerPixel * pixels, kLeastCells)));
        impl.samples_per_cell = beginning.samples_per_cell;
        round = 0;
      }
      feed(beginning.rounds - round);
      impl.rounds = std::max(1, beginning.rounds / kRoundsOfFirst);
      const LightCells cells{impl.places, beam, impl.samples_per_cell};
      impl.plan = measure.plan({impl.scene, cells, *impl.cache, optics, world_from_display});
    }
    impl.squared_goal = measure.squared_goal();
    impl.path_samples = measure.path_samples();
    add(measure.counts(), report.rays);
  } else if (impl.plan) {
    impl.cache->begin_frame(pool);
    feed(impl.rounds);
  }
  if (context.cancelled) return report;
  report.traced = !impl.plan;
  if (report.traced) {
    report.squared_error = static_cast<double>(impl.squared_goal);
    TraceParams whole = params;
    whole.spp = impl.path_samples;
    add(trace_frame(impl.device, optics, world_from_display, whole, pool, context, film), report.rays);
    return report;
  }
  report.squared_error = static_cast<double>(impl.plan->squared_error);
  if (!impl.scatter.empty()) impl.scatter = widened(impl.scatter, optics, pool);
  Scatter now;
  const LightCells cells{impl.places, beam, impl.samples_per_cell};
  const GatherSources sources{impl.scene, cells, *impl.cache, optics, world_from_display};
  add(gather_frame(sources, {params, impl.plan->error, goal.provenance}, {}, {&impl.scatter, &now}, pool, context, film),
      report.rays);
  impl.scatter = std::move(now);
  return report;
}

}  // namespace lippmann
