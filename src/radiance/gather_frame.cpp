#include "radiance/gather_frame.hpp"

#include <array>
#include <memory>
#include <numeric>

#include "core/random.hpp"
#include "radiance/block_guides.hpp"
#include "trace/frame_work.hpp"
#include "trace/trace_batch.hpp"
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
class SampleSource {
 public:
  SampleSource(const Shot& shot, const TraceParams& params)
      : rays_(shot.optics, shot.world_from_display,
              SubPixel{params.seed, kMostGatherSamples, params.angular_filter, params.lens}),
        seed_(hash(params.seed, params.frame, kPlacesSalt)),
        width_(static_cast<std::uint32_t>(film_size(shot.optics).x)),
        first_pixel_(lippmann::first_pixel(shot.optics, shot.rows)) {}

  /// Streams are pixels of the whole film.
  std::uint32_t stream_of(std::uint32_t pixel) const { return first_pixel_ + pixel; }

  /// Takes the packet's streams, which are pixels, and samples.
  void fill(CameraPacket& packet) const {
    alignas(64) float px[kLanes], py[kLanes];
    place_samples(packet, px, py);
    fill_pinholes(px, py, packet);
    if (rays_.lens().is_open()) rays_.lens().spread({packet.stream, packet.sample}, packet.rays.ray);
  }

 private:
  void fill_pinholes(const float* px, const float* py, CameraPacket& packet) const {
    if (rays_.eyes() == 1) return fill_rays(rays_.of(0), px, py, {}, packet.rays.ray);
    for (int i = 0; i < kLanes; ++i) fill_rays(rays_.of(static_cast<int>(packet.sample[i])), px, py, {i, 1}, packet.rays.ray);
  }

  /// Where on the panel samples lie: other places in every frame, as the frame before is to know of edges that this one misses.
  void place_samples(const CameraPacket& packet, float* px, float* py) const {
    const std::uint32_t seed = seed_, width = width_;
    PathPairs places;
    LIPPMANN_FOR_LANES(i) {
      places.seed[i] = hash(seed, packet.stream[i]);
      places.index[i] = packet.sample[i];
      places.first[i] = 0;
    }
    sample_pairs(places, 0, px, py);
    LIPPMANN_FOR_LANES(i) {
      constexpr float kLast = 1.0f - 1.0f / 256.0f;  // beyond it, rounding may lead to the next pixel
      px[i] = static_cast<float>(packet.stream[i] % width) + std::min(px[i], kLast);
      py[i] = static_cast<float>(packet.stream[i] / width) + std::min(py[i], kLast);
    }
  }

  SampleRays rays_;
  std::uint32_t seed_, width_, first_pixel_;
};

/// Packets of wanted samples of a block's pixels, for trace_batch(): light goes to a slot for each.
struct WantedSamples {
  const SampleSource& source;
  const BlockEstimates& block;
  std::span<const Work> work;

  bool fill(int packet, int, CameraPacket& into) const {
    const auto first = static_cast<std::size_t>(packet) * kLanes;
    for (std::size_t i = 0; i < kLanes; ++i) {
      const Work& w = work[std::min(first + i, work.size() - 1)];
      into.active.lane[i] = first + i < work.size() ? -1 : 0;
      into.target[i] = static_cast<std::uint32_t>(first + i);
      into.stream[i] = source.stream_of(block.pixel[w.estimate]);
      into.sample[i] = w.sample;
    }
    source.fill(into);
    return true;
  }
};

/// A pixel's first samples, a power of two.
constexpr std::uint32_t kFirstSamples = 2;

/// As GatherEffort::error, of alpha: the error that light may have is found from pictures that alpha's edges may not show in.
constexpr float kAlphaError = 0.01f;

class BlockGatherer {
 public:
  BlockGatherer(const GatherSources& sources, const SampleSource& samples, const GatherParams& params,
                const GatheredPictures& pictures)
      : scene_(sources.shot.device.shaded()),
        samples_(samples),
        error_(params.effort.error),
        worst_(params.effort.worst),
        light_(static_cast<int>(BlockEstimates::kMost), 1, 3),
        guides_(pictures.noisy ? std::make_unique<BlockGuides>(display_z(sources.shot.world_from_display)) : nullptr),
        gatherer_(scene_, sources.cells, sources.cache, path_params(params.trace), film(pictures),
                  {params.effort.edges, LookedUp::kAll, params.provenance, left_to_paths_.data(),
                   pictures.provenance ? looked_up_.data() : nullptr}) {}

  /// Fills a block whose pixels are listed.
  void gather(BlockEstimates& block) {
    if (guides_) guides_->begin();
    sum_looked_up_.fill(Vec2f(0.0f));
    block.alpha_weight = std::max(1.0f, error_ * error_ / (kAlphaError * kAlphaError));
    std::vector<Work> work;
    for (std::uint32_t s = 0; s < kFirstSamples; ++s)
      for (std::uint32_t e = 0; e < block.size; ++e) work.push_back({e, s});
    trace(work, block);
    for (std::uint32_t have = kFirstSamples; have < kMostGatherSamples; have *= 2) {
      work.clear();
      const auto n = static_cast<float>(have);
      encode(block);
      if (have == kFirstSamples) path_scatter_.add(block);
      block.path_scatter = path_scatter_.mean();
      find_wanted(n, error_, worst_, block);
      for (std::uint32_t e = 0; e < block.size; ++e)
        if (block.samples[e] == n && block.wanted[e] > n)
          for (std::uint32_t s = have; s < 2 * have; ++s) work.push_back({e, s});
      if (work.empty()) break;
      trace(work, block);
    }
    encode(block);
  }

  /// Writes the guides of the block that was gathered last.
  void write(const BlockEstimates& block, NoisyFrame& noisy) const { guides_->write(block, noisy); }

  /// Of the block that was gathered last, by pixel of the block: luminance that was looked up (FinalGatherOptions::looked_up),
  /// of all its samples. Known where provenance is asked for.
  Vec2f looked_up(std::size_t e) const { return sum_looked_up_[e]; }

  RayCounts counts() const { return gatherer_.counts(); }

 private:
  /// By slot.
  PathFilm film(const GatheredPictures& pictures) {
    PathFilm film{.all = light_.data.data()};
    if (pictures.alpha) film.open = open_.data();
    if (guides_) film.seen = guides_->seen_of_slots(), film.surfaces = &guides_->surfaces_of_slots();
    return film;
  }

  void trace(std::span<const Work> work, BlockEstimates& block) {
    static_assert(BlockEstimates::kMost == kPacketsPerBlock * kLanes);
    for (; !work.empty(); work = work.subspan(std::min(work.size(), BlockEstimates::kMost)))
      trace_slots(work.first(std::min(work.size(), BlockEstimates::kMost)), block);
  }

  void trace_slots(std::span<const Work> work, BlockEstimates& block) {
    const WantedSamples packets{samples_, block, work};
    for_each_batch({}, 0, static_cast<int>(packets_of(work.size())),
                   [&](std::span<const int> batch, std::size_t) { trace_batch(scene_, packets, {batch}, gatherer_); });
    for (std::size_t w = 0; w < work.size(); ++w) {
      float* light = &light_.data[3 * w];
      const Vec3f radiance(light[0], light[1], light[2]);
      block.add(work[w].estimate, radiance, open_[w], left_to_paths_[w] > 0.0f);
      if (guides_) guides_->add(work[w].estimate, work[w].sample, w, radiance);
      sum_looked_up_[work[w].estimate] += looked_up_[w];
      light[0] = light[1] = light[2] = open_[w] = left_to_paths_[w] = 0.0f, looked_up_[w] = Vec2f(0.0f);
    }
  }

  const ShadedScene& scene_;
  const SampleSource& samples_;
  float error_, worst_;
  Image light_;
  std::array<float, BlockEstimates::kMost> open_{}, left_to_paths_{};
  std::array<Vec2f, BlockEstimates::kMost> looked_up_{}, sum_looked_up_{};  ///< by slot, by pixel of the block
  PathScatter path_scatter_;
  std::unique_ptr<BlockGuides> guides_;  ///< null: nobody asks
  FinalGather gatherer_;
};

}  // namespace

FramePackets packets_in_frame(const PacketSource& source) {
  return {static_cast<std::size_t>(source.strips()), static_cast<std::size_t>(source.packets_per_strip())};
}

void append_pixels(const PacketSource& source, std::size_t first, std::size_t end, std::vector<std::uint32_t>& pixels) {
  const auto per_strip = static_cast<std::size_t>(source.packets_per_strip());
  for (std::size_t p = first; p < end; ++p)
    for_each_pixel(source, static_cast<int>(p / per_strip), static_cast<int>(p % per_strip),
                   [&](std::uint32_t pixel) { pixels.push_back(pixel); });
}

void for_each_pixel(const PacketSource& source, const std::function<void(std::size_t, std::uint32_t)>& fn) {
  std::size_t packet = 0;
  for (int strip = 0; strip < source.strips(); ++strip)
    for (int p = 0; p < source.packets_per_strip(); ++p, ++packet)
      for_each_pixel(source, strip, p, [&](std::uint32_t pixel) { fn(packet, pixel); });
}

Scatter smoothed(const Scatter& scatter, const Optics& optics, const ThreadPool& pool) {
  if (scatter.empty()) return {};
  const int width = film_size(optics).x, height = static_cast<int>(scatter.size()) / width;
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

/// The pixels of a block, or of its wanted packets alone. before: by pixel of the frame; empty: not known.
void list_pixels(const PacketSource& source, std::size_t strip, std::size_t block, std::span<const std::uint8_t> wanted,
                 const Scatter& before, BlockEstimates& estimates) {
  estimates.size = 0, estimates.across = source.across();
  const int first = static_cast<int>(block) * kPacketsPerBlock;
  const auto of_strip = strip * static_cast<std::size_t>(source.packets_per_strip());
  for (int p = first; p < std::min(source.packets_per_strip(), first + kPacketsPerBlock); ++p)
    if (wanted.empty() || wanted[of_strip + static_cast<std::size_t>(p)])
      for_each_pixel(source, static_cast<int>(strip), p,
                     [&](std::uint32_t pixel) { estimates.push_back(pixel, before.empty() ? 0.0f : before[pixel]); });
}

/// Sums up what GatherHistory expects. By strip, and so in the same order for any number of threads.
class ExpectedError {
 public:
  explicit ExpectedError(std::size_t strips) : sums_(strips, 0.0), counts_(strips, 0.0) {}

  void add(std::size_t strip, const BlockEstimates& block) {
    constexpr float kEven = 1.2f;  // 1: independent samples; measured where frames were gathered again: 1 to 1.5
    for (std::size_t e = 0; e < block.size; ++e)
      sums_[strip] +=
          static_cast<double>(std::min(block.scatter[kLanes + e], kMostScatter) / std::pow(block.samples[e], kEven));
    counts_[strip] += static_cast<double>(block.size);
  }
  double mean() const {
    return std::accumulate(sums_.begin(), sums_.end(), 0.0) /
           std::max(1.0, std::accumulate(counts_.begin(), counts_.end(), 0.0));
  }

 private:
  std::vector<double> sums_, counts_;
};

/// Where most of a pixel's light came from. all: its luminance; looked_up: as of BlockGatherer, of as many samples.
Provenance provenance_of(float all, Vec2f looked_up, const PathMix& mix) {
  const float gathered = mix.samples > 0 ? 1.0f - mix.weight : 1.0f;
  if (gathered * (looked_up.x + looked_up.y) <= 0.5f * all) return Provenance::kTraced;
  return looked_up.x >= looked_up.y ? Provenance::kSharedNow : Provenance::kSharedBefore;
}

RayCounts gather_cached(const GatherSources& sources, const GatherParams& params, std::span<const std::uint8_t> wanted,
                        const GatherHistory& history, const Workers& workers, const GatheredPictures& pictures) {
  const Vec2i size = film_size(sources.shot);
  if (history.now) history.now->assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), -1.0f);
  Image& film = pictures.film;
  film.width = size.x, film.height = size.y, film.channels = 3;
  film.data.resize(3 * static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height));
  if (pictures.noisy) clear_guides(size, *pictures.noisy);
  const Shot& shot = sources.shot;
  const PacketSource source(shot.optics, shot.world_from_display, params.trace.order, SubPixel{}, shot.rows);
  const SampleSource samples(sources.shot, params.trace);
  const Scatter unknown;
  const Scatter& before = history.before ? *history.before : unknown;
  ExpectedError expected(static_cast<std::size_t>(source.strips()));
  const RayCounts rays = trace_strips(static_cast<std::size_t>(source.strips()), workers, [&](std::size_t strip) {
    BlockGatherer gatherer(sources, samples, params, pictures);
    const auto block = std::make_unique<BlockEstimates>();
    for (std::size_t b = 0; b < blocks_in(source.packets_per_strip()) && !workers.context.cancelled; ++b) {
      list_pixels(source, strip, b, wanted, before, *block);
      if (block->size == 0) continue;
      gatherer.gather(*block);
      expected.add(strip, *block);
      for (std::size_t e = 0; e < block->size; ++e) {
        const std::size_t pixel = block->pixel[e];
        if (history.now) (*history.now)[pixel] = block->scatter[kLanes + e];
        if (pictures.alpha) pictures.alpha->data[pixel] = block->alpha(e);
        if (pictures.provenance)
          pictures.provenance->data[pixel] =
              static_cast<float>(provenance_of(block->luminance[e], gatherer.looked_up(e), params.effort.mix));
        const Vec3f radiance = block->radiance(e);
        std::copy_n(&radiance.x, 3, film.data.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
      }
      if (pictures.noisy) gatherer.write(*block, *pictures.noisy);
    }
    return gatherer.counts();
  });
  if (history.expected) *history.expected = expected.mean();
  return rays;
}

void mix_into(Image& image, const Image& more, float weight) {
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] += weight * (more.data[i] - image.data[i]);
}

Image difference(Image a, const Image& b) {
  for (std::size_t i = 0; i < a.data.size(); ++i) a.data[i] -= b.data[i];
  return a;
}

/// All light of paths is what this frame traced (FinalGatherOptions).
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
                         const Workers& workers, const GatheredPictures& pictures) {
  TraceParams trace = params.trace;
  trace.spp = params.effort.mix.samples;
  trace.seed = hash(trace.seed, 0x6d697865u);
  NoisyFrame paths;
  FrameAovs layers;
  if (pictures.alpha) layers.want(Aov::kAlpha);
  RayCounts rays;
  if (pictures.noisy) {
    rays = trace_noisy_frame(sources.shot, trace, workers, paths, layers);
    if (trace.spp == 1) paths.noise = difference(paths.film, pictures.film);  // one sample has no halves
  } else if (wanted.empty()) {
    rays = trace_frame(sources.shot, trace, workers, {paths.film, &layers});
  } else {
    paths.film = pictures.film;  // outside of `wanted` nothing changes
    rays = trace_packets(sources.shot, trace, wanted, workers, paths.film);
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
                       const GatherHistory& history, const Workers& workers, const GatheredPictures& pictures) {
  RayCounts rays = gather_cached(sources, params, wanted, history, workers, pictures);
  if (params.effort.mix.samples > 0 && !workers.context.cancelled)
    add(mix_paths_into(sources, params, wanted, workers.silent(), pictures), rays);  // the frame's progress has been told
  return rays;
}

}  // namespace lippmann
