#include "trace/trace_frame.hpp"

#include <array>
#include <atomic>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "lippmann/core/error.hpp"
#include "trace/noisy_frame.hpp"
#include "trace/packet_source.hpp"
#include "trace/path_tracer.hpp"
#include "trace/scene_query.hpp"
#include "trace/trace_packets.hpp"
#include "trace/whitted.hpp"

namespace lippmann {
namespace {

/// With which the light of samples of either half, each 1 / spp of the film's, adds up to NoisyFrame::noise.
std::array<float, 2> weights_of_halves(int spp) {
  int second = 0;
  for (int s = 0; s < spp; ++s) second += is_of_second_half(static_cast<std::uint32_t>(s)) ? 1 : 0;
  const auto weight = [&](int count) { return 0.5f * static_cast<float>(spp) / static_cast<float>(std::max(count, 1)); };
  return {weight(spp - second), -weight(second)};
}

/// What tracing a frame needs, whichever blocks of it are traced.
class FrameTracer {
 public:
  FrameTracer(const Shot& shot, const TraceParams& params, Image& film)
      : scene_(shot.device.impl()),
        params_(params),
        beam_(shot.optics, shot.world_from_display, params.spp),
        source_(shot.optics, shot.world_from_display, params.order, SubPixel{params.seed, params.spp, params.angular_filter}),
        film_(film),
        noise_weights_(weights_of_halves(params.spp)) {}

  void capture_to(const PointCapture* capture) { capture_ = capture; }
  /// Light is also added to these, which are 0 so far; of Whitted's only what is open is known.
  void split_to(const PathFilm& parts) { parts_ = parts; }
  void probe_with(const TouchProbe* probe, TouchedBlocks* touched) { probe_ = probe, touched_ = touched; }

  std::size_t strips() const { return static_cast<std::size_t>(source_.strips()); }
  std::size_t blocks_per_strip() const {
    return static_cast<std::size_t>((source_.packets_per_strip() + kPacketsPerBlock - 1) / kPacketsPerBlock);
  }

  /// Traces the blocks of a strip that are in `wanted`, by block of the frame; all of them where it is empty.
  RayCounts trace_strip(std::size_t strip, std::span<const std::uint8_t> wanted) const {
    if (scene_.path) return trace_paths_of_strip(strip, wanted);
    WhittedTracer tracer(scene_, beam_, params_.max_depth, film_);
    tracer.capture_to(capture_);
    tracer.leave_open(parts_.open);
    std::optional<BlockProbe> probe;
    if (probe_) tracer.tell(&probe.emplace(*probe_));
    for (std::size_t b = 0; b < blocks_per_strip(); ++b) {
      const std::size_t block = strip * blocks_per_strip() + b;
      if (!wanted.empty() && !wanted[block]) continue;
      const std::uint64_t rays_before = tracer.counts().total();
      trace_block(static_cast<int>(strip), static_cast<int>(b), tracer);
      if (!probe) continue;
      touched_->lowest_horizon[block] = probe->take();
      touched_->rays[block] = static_cast<std::uint32_t>(tracer.counts().total() - rays_before);
    }
    return tracer.counts();
  }

  /// trace_strip for paths, which no probe and no capture looks at.
  RayCounts trace_paths_of_strip(std::size_t strip, std::span<const std::uint8_t> wanted) const {
    PathTracer tracer(scene_, beam_, path_params(params_), film());
    for (std::size_t b = 0; b < blocks_per_strip(); ++b)
      if (wanted.empty() || wanted[strip * blocks_per_strip() + b])
        trace_block(static_cast<int>(strip), static_cast<int>(b), tracer);
    return tracer.counts();
  }

  /// Traces the packets of a strip that are in `wanted`, by packet of the frame; as many together as a block has.
  RayCounts trace_packets_of_strip(std::size_t strip, std::span<const std::uint8_t> wanted) const {
    if (!scene_.path) {
      WhittedTracer tracer(scene_, beam_, params_.max_depth, film_);
      return trace_packets_of_strip(strip, wanted, tracer);
    }
    PathTracer tracer(scene_, beam_, path_params(params_), film());
    return trace_packets_of_strip(strip, wanted, tracer);
  }

 private:
  template <class Tracer>
  RayCounts trace_packets_of_strip(std::size_t strip, std::span<const std::uint8_t> wanted, Tracer& tracer) const {
    std::vector<int> packets;
    const int count = source_.packets_per_strip();
    for (int p = 0; p < count; ++p) {
      if (wanted[strip * static_cast<std::size_t>(count) + static_cast<std::size_t>(p)]) packets.push_back(p);
      if (packets.size() < (p + 1 < count ? kPacketsPerBlock : 1)) continue;
      trace_together(static_cast<int>(strip), packets, tracer);
      packets.clear();
    }
    return tracer.counts();
  }

  PathFilm film() const {
    PathFilm film = parts_;
    film.all = film_.data.data();
    return film;
  }

  template <class Tracer>
  void trace_block(int strip, int block, Tracer& tracer) const {
    std::array<int, kPacketsPerBlock> packets;
    std::iota(packets.begin(), packets.end(), block * kPacketsPerBlock);
    const int count = std::min(kPacketsPerBlock, source_.packets_per_strip() - packets.front());
    trace_together(strip, {packets.data(), static_cast<std::size_t>(count)}, tracer);
  }

  template <class Tracer>
  void trace_together(int strip, std::span<const int> packets, Tracer& tracer) const {
    const float weight = 1.0f / static_cast<float>(params_.spp);
    RayHitPacket packet;
    LaneMask active;
    alignas(64) std::uint32_t pixel[kLanes];
    for (int sample = 0; sample < params_.spp; ++sample) {
      if constexpr (std::is_same_v<Tracer, PathTracer>)
        tracer.begin_sample(sample, noise_weights_[is_of_second_half(static_cast<std::uint32_t>(sample))]);
      for (const int p : packets) {
        if (source_.fill(strip, p, sample, packet.ray, active, pixel) == 0) continue;
        if (sample == 0) clear_pixels(active, pixel);
        tracer.primary(packet, active, pixel, weight);
      }
      tracer.finish_batch();
    }
  }

  void clear_pixels(const LaneMask& active, const std::uint32_t* pixel) const {
    for (int i = 0; i < kLanes; ++i)
      if (active.lane[i]) std::fill_n(film_.data.begin() + 3 * static_cast<std::ptrdiff_t>(pixel[i]), 3, 0.0f);
  }

  const DeviceScene::Impl& scene_;
  const TraceParams& params_;
  BeamFootprint beam_;
  PacketSource source_;
  Image& film_;
  std::array<float, 2> noise_weights_;  ///< of a sample of either half
  PathFilm parts_;
  const PointCapture* capture_ = nullptr;
  const TouchProbe* probe_ = nullptr;
  TouchedBlocks* touched_ = nullptr;
};

/// trace(strip) for every strip.
template <class Fn>
RayCounts trace_strips(std::size_t strips, const Workers& workers, const Fn& trace) {
  std::vector<RayCounts> counts(strips);
  std::atomic<std::size_t> done{0};
  const Context& context = workers.context;
  workers.pool.for_each(strips, [&](std::size_t strip) {
    if (!context.cancelled) counts[strip] = trace(strip);
    const std::size_t finished = ++done;
    if (context.frame_progress) context.frame_progress(static_cast<double>(finished) / static_cast<double>(strips));
  });
  RayCounts total;
  for (const RayCounts& c : counts) add(c, total);
  return total;
}

/// The first hits behind the centres of pixels whose samples lie elsewhere.
void capture_points(const Shot& shot, RayOrder order, const ThreadPool& pool, const PointCapture& capture) {
  const PacketSource source(shot.optics, shot.world_from_display, order, SubPixel{});
  pool.for_each(static_cast<std::size_t>(source.strips()), [&](std::size_t strip) {
    RayHitPacket packet;
    LaneMask active;
    alignas(64) std::uint32_t pixel[kLanes];
    for (int p = 0; p < source.packets_per_strip(); ++p) {
      if (source.fill(static_cast<int>(strip), p, 0, packet.ray, active, pixel) == 0) continue;
      clear_hits(packet);
      intersect_scene(shot.device.impl(), active, packet, Coherence::kCoherent);
      capture.store(packet, active, pixel);
    }
  });
}

/// Where the parts of the light go that are wanted.
PathFilm allocated_light(const Panel& panel, FrameAovs& aovs) {
  PathFilm film;
  const auto part = [&](Aov aov) -> float* {
    if (!aovs.wants(aov)) return nullptr;
    aovs.allocate(aov, panel, 0.0f);
    return aovs[aov].data.data();
  };
  film.direct = part(Aov::kDirect), film.indirect = part(Aov::kIndirect), film.open = part(Aov::kAlpha);
  return film;
}

/// From how many samples are open to the share of those that are not.
void finish_alpha(int spp, FrameAovs& aovs) {
  if (!aovs.wants(Aov::kAlpha)) return;
  for (float& alpha : aovs[Aov::kAlpha].data) alpha = std::max(0.0f, 1.0f - alpha / static_cast<float>(spp));
}

}  // namespace

void clear_guides(const Panel& panel, NoisyFrame& noisy) {
  for (Image* image : {&noisy.noise, &noisy.seen, &noisy.albedo, &noisy.normal}) *image = Image(panel.width, panel.height, 3);
  for (Image* image : {&noisy.z, &noisy.met}) *image = Image(panel.width, panel.height, 1);
}

RayCounts trace_noisy_frame(const Shot& shot, const TraceParams& params, const Workers& workers, NoisyFrame& noisy,
                            FrameAovs& aovs) {
  const Panel& panel = shot.optics.panel;
  noisy.film = Image(panel.width, panel.height, 3);
  clear_guides(panel, noisy);
  FrameTracer tracer(shot, params, noisy.film);
  PathFilm film = allocated_light(panel, aovs);
  film.noise = noisy.noise.data.data(), film.seen = noisy.seen.data.data();
  const FirstSurfaces surfaces{noisy.albedo.data.data(), noisy.normal.data.data(), noisy.z.data.data(), noisy.met.data.data(),
                               display_z(shot.world_from_display)};
  film.surfaces = &surfaces;
  tracer.split_to(film);
  const RayCounts counts = trace_strips(tracer.strips(), workers, [&](std::size_t s) { return tracer.trace_strip(s, {}); });
  finish_alpha(params.spp, aovs);
  return counts;
}

RayCounts trace_frame(const Shot& shot, const TraceParams& params, const Workers& workers, const FrameTargets& into) {
  const DeviceScene::Impl& scene = shot.device.impl();
  const Panel& panel = shot.optics.panel;
  const std::size_t pixels = static_cast<std::size_t>(panel.width) * static_cast<std::size_t>(panel.height);
  into.film.width = panel.width, into.film.height = panel.height, into.film.channels = 3;
  into.film.data.resize(3 * pixels);
  FrameTracer tracer(shot, params, into.film);
  if (into.aovs) tracer.split_to(allocated_light(panel, *into.aovs));
  std::optional<PointCapture> capture;
  if (into.points) {
    into.points->resize(pixels);
    capture.emplace(scene, inverse(shot.world_from_display), *into.points);
  }
  const bool along = capture && params.spp == 1 && !scene.path;
  if (along) tracer.capture_to(&*capture);
  std::optional<TouchProbe> probe;
  if (into.touched) {
    probe.emplace(scene.device.get(), scene.native_width, into.touched->boxes);
    const std::size_t blocks = tracer.strips() * tracer.blocks_per_strip();
    into.touched->lowest_horizon.assign(blocks, TouchedBlocks::kNever);
    into.touched->rays.assign(blocks, 0);
    tracer.probe_with(&*probe, into.touched);
  }
  const RayCounts counts = trace_strips(tracer.strips(), workers, [&](std::size_t s) { return tracer.trace_strip(s, {}); });
  if (into.aovs) finish_alpha(params.spp, *into.aovs);
  if (capture && !along) capture_points(shot, params.order, workers.pool, *capture);
  return counts;
}

RayCounts trace_blocks(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                       const Workers& workers, Image& film) {
  const FrameTracer tracer(shot, params, film);
  return trace_strips(tracer.strips(), workers, [&](std::size_t s) { return tracer.trace_strip(s, wanted); });
}

RayCounts trace_packets(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                        const Workers& workers, Image& film) {
  const FrameTracer tracer(shot, params, film);
  return trace_strips(tracer.strips(), workers, [&](std::size_t s) { return tracer.trace_packets_of_strip(s, wanted); });
}

}  // namespace lippmann
