#include "trace/gather_frame.hpp"

#include <atomic>

#include "core/random.hpp"
#include "trace/packet_source.hpp"
#include "transport/sampler.hpp"

namespace lippmann {
namespace {

/// Of sRGB's curve (0 ... 1), but for what is nearly black.
float code_of(float luminance) { return 1.055f * std::pow(std::clamp(luminance, 0.003f, 1.0f), 1.0f / 2.4f) - 0.055f; }

struct Encoded {
  float luminance;
  float code, variance;  ///< the mean's, and one sample's squared deviation from it, as sRGB's codes (0 ... 1) have them
};

/// What is known of a pixel so far.
struct PixelEstimate {
  std::uint32_t pixel = 0;
  std::uint32_t samples = 0;
  Vec3f sum{0.0f};
  float luminance_sum = 0.0f, square_sum = 0.0f;

  void add(Vec3f radiance) {
    ++samples;
    sum += radiance;
    const float y = luminance(radiance);
    luminance_sum += y;
    square_sum += y * y;
  }
  Encoded encoded() const {
    const auto n = static_cast<float>(samples);
    const float mean = luminance_sum / n, square = std::max(0.0f, square_sum / n - mean * mean);
    const float code = code_of(mean), slope = (code + 0.055f) / (2.4f * std::clamp(mean, 0.003f, 1.0f));
    return {mean, code, slope * slope * square * n / (n - 1.0f)};
  }
};

/// A sample of a pixel, to be traced.
struct Work {
  std::uint32_t estimate, sample;
};

/// Rays of any samples of any pixels.
class SamplePackets {
 public:
  SamplePackets(const Optics& optics, const Affine3f& world_from_display, const TraceParams& params)
      : rays_(optics, world_from_display, SubPixel{params.seed, kMostGatherSamples, params.angular_filter}),
        seed_(params.seed),
        width_(static_cast<std::uint32_t>(optics.panel.width)) {}

  void fill(std::span<const Work> work, std::span<const PixelEstimate> estimates, RayPacket& rays, LaneMask& active,
            std::uint32_t* pixel, std::uint32_t* sample) const {
    alignas(64) float px[kLanes], py[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
      const Work& w = work[std::min(i, work.size() - 1)];
      active.lane[i] = i < work.size() ? -1 : 0;
      pixel[i] = estimates[w.estimate].pixel;
      sample[i] = w.sample;
      const Vec2f at = glm::min(scrambled_sobol(w.sample, hash(seed_, pixel[i])), Vec2f(1.0f - 1.0f / 256.0f));
      px[i] = static_cast<float>(pixel[i] % width_) + at.x;
      py[i] = static_cast<float>(pixel[i] / width_) + at.y;
    }
    if (rays_.eyes() == 1) return fill(rays_.of(0), px, py, 0, kLanes, rays);
    for (int i = 0; i < kLanes; ++i) fill(rays_.of(static_cast<int>(sample[i])), px, py, i, 1, rays);
  }

 private:
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

/// A pixel's first samples, powers of two: where little is to be expected, and else.
constexpr std::uint32_t kLeastSamples = 2, kUsualSamples = 4;

/// What all samples of a pixel may have missed: about 1 / (samples + 2) of its area, as bright as a pixel beside it. Such
/// misses count as this much of their square, found by trial.
constexpr float kMissed = 0.05f;
/// What a pixel's neighbours scatter says something of it while it has no more samples.
constexpr std::uint32_t kFewSamples = 4;

/// Errors of n evenly spread samples fall about as n^-1.6: for the least error of all pixels together, their number grows as
/// the power 2 / 2.6 of how much they scatter.
float samples_for(float variance, float error) { return std::pow(variance / (error * error), 0.385f); }

constexpr std::size_t kBlockPixels = kPacketsPerBlock * kLanes;

class BlockGatherer {
 public:
  BlockGatherer(const GatherSources& sources, const SamplePackets& packets, const GatherParams& params,
                const GatherHistory& history)
      : packets_(packets),
        before_(history.before && !history.before->empty() ? history.before->data() : nullptr),
        error_(params.error),
        light_(kBlockPixels, 1, 3),
        gatherer_(sources.scene, sources.cells, sources.cache,
                  {params.trace.max_depth, hash(params.trace.seed, params.trace.frame), params.trace.clamp_indirect}, light_) {
    if (params.provenance) gatherer_.show_provenance();
  }

  void gather(std::vector<PixelEstimate>& estimates) {
    std::vector<Work> work;
    for (std::uint32_t s = 0; s < kUsualSamples; ++s)
      for (std::uint32_t e = 0; e < estimates.size(); ++e)
        if (s < first_samples(estimates[e].pixel)) work.push_back({e, s});
    trace(work, estimates);
    encoded_.resize(estimates.size());
    for (std::uint32_t have = kLeastSamples; have < kMostGatherSamples; have *= 2) {
      work.clear();
      for (std::size_t e = 0; e < estimates.size(); ++e)
        if (estimates[e].samples >= have || have == kLeastSamples) encoded_[e] = estimates[e].encoded();
      for (std::uint32_t e = 0; e < estimates.size(); ++e)
        if (estimates[e].samples == have && wanted(have, e) > static_cast<float>(have))
          for (std::uint32_t s = have; s < 2 * have; ++s) work.push_back({e, s});
      trace(work, estimates);
    }
  }

  RayCounts counts() const { return gatherer_.counts(); }

 private:
  std::uint32_t first_samples(std::uint32_t pixel) const {
    return before_ && samples_for(before_[pixel], error_) <= static_cast<float>(kLeastSamples) ? kLeastSamples : kUsualSamples;
  }

  /// Samples that a pixel should have. What it has may have missed an edge, which those around then know of: by how much they
  /// scatter, or as they are brighter or darker.
  float wanted(std::uint32_t have, std::size_t e) const {
    const Encoded& own = encoded_[e];
    float around = 0.0f, count = 0.0f, least = own.luminance, most = own.luminance;
    const auto look_at = [&](const Encoded& other) {
      around += other.variance, count += 1.0f;
      least = std::min(least, other.luminance), most = std::max(most, other.luminance);
    };
    for (const std::size_t step : {std::size_t{1}, std::size_t{kLanes}}) {
      if (e >= step) look_at(encoded_[e - step]);
      if (e + step < encoded_.size()) look_at(encoded_[e + step]);
    }
    float variance = own.variance;
    if (have <= kFewSamples && count > 0.0f) variance = std::max(variance, 0.5f * (variance + around / count));
    variance += missed(own, most, have) + missed(own, least, have);
    return samples_for(variance, error_);
  }

  /// The scatter of which samples as many as these would leave the error of having missed light of another `luminance`.
  static float missed(const Encoded& own, float luminance, std::uint32_t have) {
    // A difference that is not seen.
    constexpr float kSlight = 0.05f;
    if (std::abs(luminance - own.luminance) <= kSlight * own.luminance) return 0.0f;
    const auto n = static_cast<float>(have);
    const float error = code_of(own.luminance + (luminance - own.luminance) / (n + 2.0f)) - own.code;
    return kMissed * std::pow(n, 1.6f) * error * error;
  }

  void trace(std::span<const Work> work, std::vector<PixelEstimate>& estimates) {
    RayHitPacket packet;
    LaneMask active;
    alignas(64) std::uint32_t pixel[kLanes], sample[kLanes], slot[kLanes];
    for (std::size_t begin = 0; begin < work.size(); begin += kBlockPixels) {
      const std::size_t end = std::min(work.size(), begin + kBlockPixels);
      for (std::size_t first = begin; first < end; first += kLanes) {
        packets_.fill(work.subspan(first, std::min<std::size_t>(kLanes, end - first)), estimates, packet.ray, active, pixel,
                      sample);
        for (std::uint32_t i = 0; i < kLanes; ++i) slot[i] = static_cast<std::uint32_t>(first - begin) + i;
        gatherer_.primary(packet, active, pixel, sample, slot);
      }
      gatherer_.finish_batch();
      for (std::size_t w = begin; w < end; ++w) {
        float* light = &light_.data[3 * (w - begin)];
        estimates[work[w].estimate].add({light[0], light[1], light[2]});
        light[0] = light[1] = light[2] = 0.0f;
      }
    }
  }

  const SamplePackets& packets_;
  const float* before_;
  float error_;
  Image light_;
  LightGatherer gatherer_;
  std::vector<Encoded> encoded_;  ///< by estimate
};

std::size_t blocks_per_strip(const PacketSource& source) {
  return static_cast<std::size_t>((source.packets_per_strip() + kPacketsPerBlock - 1) / kPacketsPerBlock);
}

/// The pixels of a block, in the order of rays.
void list_pixels(const PacketSource& source, std::size_t strip, std::size_t block, std::vector<PixelEstimate>& estimates) {
  RayPacket rays;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  estimates.clear();
  const int first = static_cast<int>(block) * kPacketsPerBlock;
  for (int p = first; p < std::min(source.packets_per_strip(), first + kPacketsPerBlock); ++p) {
    if (source.fill(static_cast<int>(strip), p, 0, rays, active, pixel) == 0) continue;
    for (int i = 0; i < kLanes; ++i)
      if (active.lane[i]) estimates.emplace_back().pixel = pixel[i];
  }
}

}  // namespace

std::size_t blocks_in_frame(const Optics& optics, const Affine3f& world_from_display, RayOrder order) {
  const PacketSource source(optics, world_from_display, order, SubPixel{});
  return static_cast<std::size_t>(source.strips()) * blocks_per_strip(source);
}

Scatter widened(const Scatter& scatter, const Optics& optics, const ThreadPool& pool) {
  const int width = optics.panel.width, height = optics.panel.height;
  const int lens = std::max(1, whole_pixels_per_lens(optics).x);
  Scatter across(scatter.size()), wide(scatter.size());
  const auto widen = [&](const Scatter& from, Scatter& to, auto... steps) {
    pool.for_each(static_cast<std::size_t>(height), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        float most = 0.0f;
        for (const Vec2i step : {Vec2i(0, 0), steps...}) {
          const Vec2i at = glm::clamp(Vec2i(x, y) + step, Vec2i(0), Vec2i(width - 1, height - 1));
          most = std::max(
              most, from[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(at.x)]);
        }
        to[row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = most;
      }
    });
  };
  widen(scatter, across, Vec2i(-1, 0), Vec2i(1, 0), Vec2i(-lens, 0), Vec2i(lens, 0));
  widen(across, wide, Vec2i(0, -1), Vec2i(0, 1), Vec2i(0, -2), Vec2i(0, 2));
  return wide;
}

RayCounts gather_frame(const GatherSources& sources, const GatherParams& params, std::span<const std::uint8_t> wanted,
                       const GatherHistory& history, const ThreadPool& pool, const Context& context, Image& film) {
  if (history.now)
    history.now->resize(static_cast<std::size_t>(sources.optics.panel.width) *
                        static_cast<std::size_t>(sources.optics.panel.height));
  const Optics& optics = sources.optics;
  film.width = optics.panel.width, film.height = optics.panel.height, film.channels = 3;
  film.data.resize(3 * static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height));
  const PacketSource source(optics, sources.world_from_display, params.trace.order, SubPixel{});
  const SamplePackets packets(optics, sources.world_from_display, params.trace);
  const auto strips = static_cast<std::size_t>(source.strips());
  const std::size_t blocks = blocks_per_strip(source);
  std::vector<RayCounts> counts(strips);
  std::atomic<std::size_t> done{0};
  pool.for_each(strips, [&](std::size_t strip) {
    BlockGatherer gatherer(sources, packets, params, history);
    std::vector<PixelEstimate> estimates;
    for (std::size_t b = 0; b < blocks && !context.cancelled; ++b) {
      if (!wanted.empty() && !wanted[strip * blocks + b]) continue;
      list_pixels(source, strip, b, estimates);
      gatherer.gather(estimates);
      for (const PixelEstimate& e : estimates) {
        if (history.now) (*history.now)[e.pixel] = e.encoded().variance;
        for (int c = 0; c < 3; ++c)
          film.data[3 * static_cast<std::size_t>(e.pixel) + static_cast<std::size_t>(c)] =
              e.sum[c] / static_cast<float>(e.samples);
      }
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

}  // namespace lippmann
