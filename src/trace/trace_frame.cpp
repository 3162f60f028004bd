#include "trace/trace_frame.hpp"

#include <optional>

#include "trace/integrator_model.hpp"
#include "trace/noisy_frame.hpp"
#include "trace/trace_batch.hpp"
#include "trace/trace_packets.hpp"

namespace lippmann {
namespace {

class FrameTracer {
 public:
  /// Adds light to `film` and to `parts`, whose arrays must be filled with 0.
  FrameTracer(const Shot& shot, const TraceParams& params, Image& film, const PathFilm& parts = {})
      : scene_(shot.device.shaded()),
        integrator_(shot.device.integrator().model()),
        params_(params),
        beam_(shot.optics, shot.world_from_display, params.spp),
        source_(shot.optics, shot.world_from_display, params.order,
                SubPixel{params.seed, params.spp, params.angular_filter, params.lens}, shot.rows),
        sinks_{&film},
        film_(parts) {
    film_.all = film.data.data();
  }

  /// Traces only this subset of the samples from now on. Subsets after the first add to the film instead of clearing it.
  void take(SampleShare share) {
    share_ = share;
    if (!share.is_first()) sinks_.film = nullptr;
  }

  void capture_to(const PointCapture* points) { sinks_.points = points; }

  /// From now on, marks in `touched` the blocks whose rays meet the boxes of `probe`.
  void probe_with(const TouchProbe& probe, TouchedBlocks& touched) {
    const std::size_t blocks = static_cast<std::size_t>(source_.strips()) * blocks_in(source_.packets_per_strip());
    touched.lowest_horizon.assign(blocks, TouchedBlocks::kNever);
    touched.rays.assign(blocks, 0);
    probe_ = &probe, touched_ = &touched;
  }

  RayCounts trace(const FrameWork& work, const Workers& workers) const {
    return trace_strips(
        static_cast<std::size_t>(source_.strips()), workers,
        [&](std::size_t strip) { return trace_strip(work, strip, workers.context); }, share_);
  }

 private:
  /// Checks for cancellation before each batch, because a strip with many samples may take minutes.
  RayCounts trace_strip(const FrameWork& work, std::size_t strip, const Context& context) const {
    const std::unique_ptr<FrameIntegrator> integrator = integrator_.make({scene_, beam_, params_, film_});
    std::optional<BlockProbe> probe;
    if (probe_) integrator->set_probe(&probe.emplace(*probe_));
    const StripPackets packets{source_, static_cast<int>(strip)};
    for_each_batch(work, strip, source_.packets_per_strip(), [&](std::span<const int> batch, std::size_t block) {
      if (context.cancelled) return;
      const std::uint64_t rays_before = integrator->counts().total();
      trace_batch(scene_, packets, {batch, share_.first, params_.spp, share_.step}, *integrator, sinks_);
      if (!probe) return;
      touched_->lowest_horizon[block] = probe->take();
      touched_->rays[block] = static_cast<std::uint32_t>(integrator->counts().total() - rays_before);
    });
    return integrator->counts();
  }

  const ShadedScene& scene_;
  const IntegratorModel& integrator_;
  const TraceParams& params_;
  BeamFootprint beam_;
  PacketSource source_;
  PacketSinks sinks_;
  PathFilm film_;
  SampleShare share_;
  const TouchProbe* probe_ = nullptr;
  TouchedBlocks* touched_ = nullptr;
};

constexpr Aov kLayersOfLight[] = {Aov::kDirect, Aov::kIndirect, Aov::kAlpha};

void allocate_light(Vec2i film_size, FrameAovs& aovs) {
  for (const Aov aov : kLayersOfLight)
    if (aovs.wants(aov)) aovs.allocate(aov, film_size);
}

/// Returns pointers to the requested light layers, which must be allocated.
PathFilm light_in(FrameAovs& aovs) {
  PathFilm film;
  const auto part = [&](Aov aov) { return aovs.wants(aov) ? aovs[aov].data.data() : nullptr; };
  film.direct = part(Aov::kDirect), film.indirect = part(Aov::kIndirect), film.open = part(Aov::kAlpha);
  return film;
}

/// Converts the alpha layer from the number of samples that hit nothing to coverage.
void finish_alpha(int spp, FrameAovs& aovs) {
  if (!aovs.wants(Aov::kAlpha)) return;
  for (float& alpha : aovs[Aov::kAlpha].data) alpha = std::max(0.0f, 1.0f - alpha / static_cast<float>(spp));
}

}  // namespace

std::array<float, 2> weights_of_halves(int spp) {
  int second = 0;
  for (int s = 0; s < spp; ++s) second += is_of_second_half(static_cast<std::uint32_t>(s)) ? 1 : 0;
  const auto weight = [&](int count) { return 0.5f * static_cast<float>(spp) / static_cast<float>(std::max(count, 1)); };
  return {weight(spp - second), -weight(second)};
}

RayCounts trace_noisy_frame(const Shot& shot, const TraceParams& params, const Workers& workers, NoisyFrame& noisy,
                            FrameAovs& aovs, SampleShare share) {
  if (share.is_first()) {
    const Vec2i size = film_size(shot);
    for (Image* image : {&noisy.film, &noisy.noise, &noisy.seen, &noisy.albedo, &noisy.normal})
      *image = Image(size.x, size.y, 3);
    for (Image* image : {&noisy.z, &noisy.met}) *image = Image(size.x, size.y, 1);
    allocate_light(size, aovs);
  }
  PathFilm film = light_in(aovs);
  film.noise = noisy.noise.data.data(), film.seen = noisy.seen.data.data();
  const FirstSurfaces surfaces{noisy.albedo.data.data(), noisy.normal.data.data(), noisy.z.data.data(), noisy.met.data.data(),
                               display_z(shot.world_from_display)};
  film.surfaces = &surfaces;
  FrameTracer tracer(shot, params, noisy.film, film);
  tracer.take(share);
  const RayCounts counts = tracer.trace({}, workers);
  if (share.is_last()) finish_alpha(params.spp, aovs);
  return counts;
}

RayCounts trace_frame(const Shot& shot, const TraceParams& params, const Workers& workers, const TraceTargets& into,
                      SampleShare share) {
  const ShadedScene& scene = shot.device.shaded();
  const Vec2i size = film_size(shot);
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  into.film.width = size.x, into.film.height = size.y, into.film.channels = 3;
  into.film.data.resize(3 * pixels);
  if (into.aovs && share.is_first()) allocate_light(size, *into.aovs);
  FrameTracer tracer(shot, params, into.film, into.aovs ? light_in(*into.aovs) : PathFilm{});
  tracer.take(share);
  std::optional<PointCapture> capture;
  if (into.points) {
    into.points->resize(pixels);
    capture.emplace(scene, inverse(shot.world_from_display), *into.points);
  }
  const bool along = capture && params.spp == 1;
  if (along) tracer.capture_to(&*capture);
  std::optional<TouchProbe> probe;
  if (into.touched) {
    probe.emplace(scene, into.touched->boxes);
    tracer.probe_with(*probe, *into.touched);
  }
  const RayCounts counts = tracer.trace({}, workers);
  if (into.aovs && share.is_last()) finish_alpha(params.spp, *into.aovs);
  NoIntegrator none;
  if (capture && !along) trace_centres(shot, params.order, workers.pool, none, {nullptr, &*capture});
  return counts;
}

RayCounts trace_blocks(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                       const Workers& workers, Image& film) {
  return FrameTracer(shot, params, film).trace({FrameWork::Unit::kBlocks, wanted}, workers);
}

RayCounts trace_packets(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                        const Workers& workers, Image& film) {
  return FrameTracer(shot, params, film).trace({FrameWork::Unit::kPackets, wanted}, workers);
}

}  // namespace lippmann
