#include "trace/gather_frame.hpp"

#include <array>
#include <atomic>
#include <memory>

#include "core/random.hpp"
#include "trace/block_guides.hpp"
#include "trace/packet_source.hpp"
#include "trace/trace_packets.hpp"
#include "transport/sampler.hpp"

namespace lippmann {
namespace {

/// A sample of a pixel, to be traced.
struct Work {
  std::uint32_t estimate, sample;
};

/// Where a sample lies must have nothing to do with what is decided along its path.
constexpr std::uint32_t kPlacesSalt = 0x706c6163u;

/// Rays of any samples of any pixels.
class SamplePackets {
 public:
  SamplePackets(const Optics& optics, const Affine3f& world_from_display, const TraceParams& params)
      : rays_(optics, world_from_display, SubPixel{params.seed, kMostGatherSamples, params.angular_filter}),
        seed_(hash(params.seed, params.frame, kPlacesSalt)),
        width_(static_cast<std::uint32_t>(optics.panel.width)) {}

  void fill(std::span<const Work> work, const BlockEstimates& block, RayPacket& rays, LaneMask& active, std::uint32_t* pixel,
            std::uint32_t* sample) const {
    PathPairs places;
    for (std::size_t i = 0; i < kLanes; ++i) {
      const Work& w = work[std::min(i, work.size() - 1)];
      active.lane[i] = i < work.size() ? -1 : 0;
      pixel[i] = block.pixel[w.estimate];
      places.index[i] = sample[i] = w.sample;
    }
    alignas(64) float px[kLanes], py[kLanes];
    place_samples(pixel, places, px, py);
    if (rays_.eyes() == 1) return fill(rays_.of(0), px, py, 0, kLanes, rays);
    for (int i = 0; i < kLanes; ++i) fill(rays_.of(static_cast<int>(sample[i])), px, py, i, 1, rays);
  }

 private:
  /// Where on the panel samples lie: other places in every frame, as the frame before is to know of edges that this one misses.
  void place_samples(const std::uint32_t* pixel, PathPairs& places, float* px, float* py) const {
    const std::uint32_t seed = seed_, width = width_;
    LIPPMANN_FOR_LANES(i) {
      places.seed[i] = hash(seed, pixel[i]);
      places.first[i] = 0;
    }
    sample_pairs(places, 0, px, py);
    LIPPMANN_FOR_LANES(i) {
      constexpr float kLast = 1.0f - 1.0f / 256.0f;  // beyond it, rounding may lead to the next pixel
      px[i] = static_cast<float>(pixel[i] % width) + std::min(px[i], kLast);
      py[i] = static_cast<float>(pixel[i] / width) + std::min(py[i], kLast);
    }
  }

  static void fill(const RayGenerator& generator, const float* px, const float* py, int first, int count, RayPacket& rays) {
    generator.rays(px + first, py + first, count,
                   {rays.org_x + first, rays.org_y + first, rays.org_z + first, rays.dir_x + first, rays.dir_y + first,
                    rays.dir_z + first});
    const Vec3f forward = generator.forward();
    for (int i = first; i < first + count; ++i) {
      rays.tnear[i] = 0.0f;
      rays.tfar[i] = generator.depth() / (rays.dir_x[i] * forward.x + rays.dir_y[i] * forward.y + rays.dir_z[i] * forward.z);
    }
  }

  SampleRays rays_;
  std::uint32_t seed_, width_;
};

/// A pixel's first samples, a power of two.
constexpr std::uint32_t kFirstSamples = 2;

/// As GatherEffort::error, of alpha: the error that light may have is found from pictures that alpha's edges may not show in.
constexpr float kAlphaError = 0.01f;

class BlockGatherer {
 public:
  BlockGatherer(const GatherSources& sources, const SamplePackets& packets, const GatherParams& params,
                const GatheredPictures& pictures)
      : packets_(packets),
        error_(params.effort.error),
        light_(static_cast<int>(BlockEstimates::kMost), 1, 3),
        gatherer_(sources.scene.impl(), sources.cells, sources.cache, path_params(params.trace), light_) {
    gatherer_.leave_to_paths(params.effort.edges);
    if (params.provenance) gatherer_.show_provenance();
    if (pictures.alpha) gatherer_.leave_open(open_.data());
    if (!pictures.noisy) return;
    guides_ = std::make_unique<BlockGuides>(display_z(sources.world_from_display));
    gatherer_.describe(guides_->surfaces_of_slots(), guides_->seen_of_slots());
  }

  /// Fills a block whose pixels are listed.
  void gather(BlockEstimates& block) {
    if (guides_) guides_->begin();
    block.alpha_weight = std::max(1.0f, error_ * error_ / (kAlphaError * kAlphaError));
    std::vector<Work> work;
    for (std::uint32_t s = 0; s < kFirstSamples; ++s)
      for (std::uint32_t e = 0; e < block.size; ++e) work.push_back({e, s});
    trace(work, block);
    for (std::uint32_t have = kFirstSamples; have < kMostGatherSamples; have *= 2) {
      work.clear();
      const auto n = static_cast<float>(have);
      encode(block);
      find_wanted(n, error_, block);
      for (std::uint32_t e = 0; e < block.size; ++e)
        if (block.samples[e] == n && block.wanted[e] > n)
          for (std::uint32_t s = have; s < 2 * have; ++s) work.push_back({e, s});
      if (work.empty()) break;
      trace(work, block);
    }
    encode(block);
  }

  /// Of the block that was gathered last.
  void write(const BlockEstimates& block, NoisyFrame& noisy) const { guides_->write(block, noisy); }

  RayCounts counts() const { return gatherer_.counts(); }

 private:
  void trace(std::span<const Work> work, BlockEstimates& block) {
    RayHitPacket packet;
    LaneMask active;
    alignas(64) std::uint32_t pixel[kLanes], sample[kLanes], slot[kLanes];
    for (std::size_t begin = 0; begin < work.size(); begin += BlockEstimates::kMost) {
      const std::size_t end = std::min(work.size(), begin + BlockEstimates::kMost);
      for (std::size_t first = begin; first < end; first += kLanes) {
        packets_.fill(work.subspan(first, std::min<std::size_t>(kLanes, end - first)), block, packet.ray, active, pixel,
                      sample);
        for (std::uint32_t i = 0; i < kLanes; ++i) slot[i] = static_cast<std::uint32_t>(first - begin) + i;
        gatherer_.primary(packet, active, pixel, sample, slot);
      }
      gatherer_.finish_batch();
      for (std::size_t w = begin; w < end; ++w) {
        float* light = &light_.data[3 * (w - begin)];
        const Vec3f radiance(light[0], light[1], light[2]);
        block.add(work[w].estimate, radiance, open_[w - begin]);
        if (guides_) guides_->add(work[w].estimate, work[w].sample, w - begin, radiance);
        light[0] = light[1] = light[2] = open_[w - begin] = 0.0f;
      }
    }
  }

  const SamplePackets& packets_;
  float error_;
  Image light_;
  std::array<float, BlockEstimates::kMost> open_{};
  std::unique_ptr<BlockGuides> guides_;  ///< null: nobody asks
  LightGatherer gatherer_;
};

std::size_t blocks_per_strip(const PacketSource& source) {
  return static_cast<std::size_t>((source.packets_per_strip() + kPacketsPerBlock - 1) / kPacketsPerBlock);
}

/// The pixels of a block, or of its wanted packets alone. before: of the frame; empty: not known.
void list_pixels(const PacketSource& source, std::size_t strip, std::size_t block, std::span<const std::uint8_t> wanted,
                 const Scatter& before, BlockEstimates& estimates) {
  RayPacket rays;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  estimates.size = 0;
  const int first = static_cast<int>(block) * kPacketsPerBlock;
  const auto of_strip = strip * static_cast<std::size_t>(source.packets_per_strip());
  for (int p = first; p < std::min(source.packets_per_strip(), first + kPacketsPerBlock); ++p) {
    if (!wanted.empty() && !wanted[of_strip + static_cast<std::size_t>(p)]) continue;
    if (source.fill(static_cast<int>(strip), p, 0, rays, active, pixel) == 0) continue;
    for (int i = 0; i < kLanes; ++i)
      if (active.lane[i]) estimates.push_back(pixel[i], before.empty() ? 0.0f : before[pixel[i]]);
  }
}

}  // namespace

FramePackets packets_in_frame(const Optics& optics, const Affine3f& world_from_display, RayOrder order) {
  const PacketSource source(optics, world_from_display, order, SubPixel{});
  return {static_cast<std::size_t>(source.strips()), static_cast<std::size_t>(source.packets_per_strip())};
}

void append_pixels(const Optics& optics, const Affine3f& world_from_display, RayOrder order, std::size_t first, std::size_t end,
                   std::vector<std::uint32_t>& pixels) {
  const PacketSource source(optics, world_from_display, order, SubPixel{});
  const auto per_strip = static_cast<std::size_t>(source.packets_per_strip());
  RayPacket rays;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  for (std::size_t p = first; p < end; ++p) {
    if (source.fill(static_cast<int>(p / per_strip), static_cast<int>(p % per_strip), 0, rays, active, pixel) == 0) continue;
    for (int i = 0; i < kLanes; ++i)
      if (active.lane[i]) pixels.push_back(pixel[i]);
  }
}

void for_each_pixel(const Optics& optics, const Affine3f& world_from_display, RayOrder order,
                    const std::function<void(std::size_t, std::uint32_t)>& fn) {
  const PacketSource source(optics, world_from_display, order, SubPixel{});
  RayPacket rays;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  std::size_t packet = 0;
  for (int strip = 0; strip < source.strips(); ++strip)
    for (int p = 0; p < source.packets_per_strip(); ++p, ++packet) {
      if (source.fill(strip, p, 0, rays, active, pixel) == 0) continue;
      for (int i = 0; i < kLanes; ++i)
        if (active.lane[i]) fn(packet, pixel[i]);
    }
}

Scatter smoothed(const Scatter& scatter, const Optics& optics, const ThreadPool& pool) {
  if (scatter.empty()) return {};
  const int width = optics.panel.width, height = optics.panel.height;
  const int lens = std::max(1, whole_pixels_per_lens(optics).x);
  Scatter across(scatter.size()), smooth(scatter.size());
  const auto average = [&](const Scatter& from, Scatter& to, auto... steps) {
    pool.for_each(static_cast<std::size_t>(height), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        float sum = 0.0f, count = 0.0f;
        for (const Vec2i step : {Vec2i(0, 0), steps...}) {
          const Vec2i at = glm::clamp(Vec2i(x, y) + step, Vec2i(0), Vec2i(width - 1, height - 1));
          const float v =
              from[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(at.x)];
          sum += v >= 0.0f ? v : 0.0f, count += v >= 0.0f ? 1.0f : 0.0f;
        }
        to[row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = count > 0.0f ? sum / count : -1.0f;
      }
    });
  };
  average(scatter, across, Vec2i(-1, 0), Vec2i(1, 0), Vec2i(-lens, 0), Vec2i(lens, 0));
  average(across, smooth, Vec2i(0, -1), Vec2i(0, 1), Vec2i(0, -2), Vec2i(0, 2));
  for (std::size_t i = 0; i < scatter.size(); ++i)
    if (scatter[i] >= 0.0f) smooth[i] = 0.5f * (scatter[i] + smooth[i]);
  return smooth;
}

namespace {

RayCounts gather_cached(const GatherSources& sources, const GatherParams& params, std::span<const std::uint8_t> wanted,
                        const GatherHistory& history, const ThreadPool& pool, const Context& context,
                        const GatheredPictures& pictures) {
  if (history.now)
    history.now->assign(
        static_cast<std::size_t>(sources.optics.panel.width) * static_cast<std::size_t>(sources.optics.panel.height), -1.0f);
  const Optics& optics = sources.optics;
  Image& film = pictures.film;
  film.width = optics.panel.width, film.height = optics.panel.height, film.channels = 3;
  film.data.resize(3 * static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height));
  if (pictures.noisy) clear_guides(optics.panel, *pictures.noisy);
  const PacketSource source(optics, sources.world_from_display, params.trace.order, SubPixel{});
  const SamplePackets packets(optics, sources.world_from_display, params.trace);
  const auto strips = static_cast<std::size_t>(source.strips());
  const std::size_t blocks = blocks_per_strip(source);
  std::vector<RayCounts> counts(strips);
  std::atomic<std::size_t> done{0};
  const Scatter unknown;
  pool.for_each(strips, [&](std::size_t strip) {
    BlockGatherer gatherer(sources, packets, params, pictures);
    const auto block = std::make_unique<BlockEstimates>();
    for (std::size_t b = 0; b < blocks && !context.cancelled; ++b) {
      list_pixels(source, strip, b, wanted, history.before ? *history.before : unknown, *block);
      if (block->size == 0) continue;
      gatherer.gather(*block);
      for (std::size_t e = 0; e < block->size; ++e) {
        const std::size_t pixel = block->pixel[e];
        if (history.now) (*history.now)[pixel] = block->scatter[kLanes + e];
        if (pictures.alpha) pictures.alpha->data[pixel] = block->alpha(e);
        const Vec3f radiance = block->radiance(e);
        std::copy_n(&radiance.x, 3, film.data.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
      }
      if (pictures.noisy) gatherer.write(*block, *pictures.noisy);
    }
    counts[strip] = gatherer.counts();
    const std::size_t finished = ++done;
    if (wanted.empty() && context.frame_progress)
      context.frame_progress(static_cast<double>(finished) / static_cast<double>(strips));
  });
  RayCounts total;
  for (const RayCounts& c : counts) add(c, total);
  return total;
}

void mix_into(Image& image, const Image& more, float weight) {
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] += weight * (more.data[i] - image.data[i]);
}

Image difference(Image a, const Image& b) {
  for (std::size_t i = 0; i < a.data.size(); ++i) a.data[i] -= b.data[i];
  return a;
}

/// All light of paths is what this frame traced (LightGatherer::show_provenance).
void show_as_traced(Image& film) {
  for (std::size_t i = 0; i < film.data.size(); i += 3) {
    const float all = luminance(Vec3f(film.data[i], film.data[i + 1], film.data[i + 2]));
    film.data[i] = all, film.data[i + 1] = film.data[i + 2] = 0.0f;
  }
}

void mix_into(NoisyFrame& noisy, const NoisyFrame& more, float weight) {
  for (Image NoisyFrame::*image :
       {&NoisyFrame::noise, &NoisyFrame::seen, &NoisyFrame::albedo, &NoisyFrame::normal, &NoisyFrame::z, &NoisyFrame::met})
    mix_into(noisy.*image, more.*image, weight);
}

/// Paths with random numbers of their own, so that their errors have nothing to do with those of what they are mixed into.
RayCounts mix_paths_into(const GatherSources& sources, const GatherParams& params, std::span<const std::uint8_t> wanted,
                         const ThreadPool& pool, const GatheredPictures& pictures) {
  const auto& [device, cells, cache, optics, world_from_display] = sources;
  TraceParams trace = params.trace;
  trace.spp = params.effort.mix.samples;
  trace.seed = hash(trace.seed, 0x6d697865u);
  const Context quiet;  // the frame's progress has been told
  NoisyFrame paths;
  FrameAovs layers;
  if (pictures.alpha) layers.want(Aov::kAlpha);
  RayCounts rays;
  if (pictures.noisy) {
    rays = trace_noisy_frame({device, optics, world_from_display}, trace, {pool, quiet}, paths, layers);
    if (trace.spp == 1) paths.noise = difference(paths.film, pictures.film);  // of one sample there are no halves
  } else if (wanted.empty()) {
    rays = trace_frame({device, optics, world_from_display}, trace, {pool, quiet}, {paths.film, &layers});
  } else {
    paths.film = pictures.film;  // outside of `wanted` nothing changes
    rays = trace_packets({device, optics, world_from_display}, trace, wanted, {pool, quiet}, paths.film);
  }
  if (params.provenance) show_as_traced(paths.film);
  const float weight = params.effort.mix.weight;
  mix_into(pictures.film, paths.film, weight);
  if (pictures.alpha) mix_into(*pictures.alpha, layers[Aov::kAlpha], weight);
  if (pictures.noisy) mix_into(*pictures.noisy, paths, weight);
  return rays;
}

}  // namespace

RayCounts gather_frame(const GatherSources& sources, const GatherParams& params, std::span<const std::uint8_t> wanted,
                       const GatherHistory& history, const ThreadPool& pool, const Context& context,
                       const GatheredPictures& pictures) {
  RayCounts rays = gather_cached(sources, params, wanted, history, pool, context, pictures);
  if (params.effort.mix.samples > 0 && !context.cancelled) add(mix_paths_into(sources, params, wanted, pool, pictures), rays);
  return rays;
}

}  // namespace lippmann
