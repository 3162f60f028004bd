#include "radiance/block_estimates.hpp"

#include <limits>

#include "device/fast_math.hpp"
#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

/// What all samples of a pixel may have missed: about 1 / (samples + 2) of its area, as bright as a pixel beside it. How much
/// of its square such a miss counts as: of the pixels beside another brightness, about one in three has the edge within. Two
/// samples of every second of these agree, of eight those of one in seven, and then the more they are, the less lies beyond.
LIPPMANN_INLINE float share_missed(float samples) { return 0.05f + 1.1f / (samples * samples); }
/// A difference of luminance that is not seen.
constexpr float kSlight = 0.05f;
/// With fewer samples a pixel has no say in how many more it gets: its neighbours and the frame before have. Else those whose
/// first samples happen to have missed something bright would be left with that, while those that have met it are set right,
/// and the picture would be too dark by it.
constexpr float kOwnSamples = 8.0f;
/// And then, for the same reason, its neighbours count as so many samples of its own. What is met by one sample in twenty, as a
/// lamp that few samples choose, takes more than 8 to be sure of.
constexpr float kNeighbours = 64.0f;
/// For the least error of all pixels together, the number of their samples grows as the power 2 / (1 + kErrorFall) of how much
/// these scatter.
constexpr float kGrowth = 1.0f / (1.0f + kErrorFall);

/// Luminance above it, as far as codes tell it apart: white is white, and black black.
constexpr float kBlack = 0.003f;

// std::min() and std::max() take references, which keep a loop from being made wide.
LIPPMANN_INLINE float smaller(float a, float b) { return b < a ? b : a; }
LIPPMANN_INLINE float larger(float a, float b) { return a < b ? b : a; }

LIPPMANN_INLINE float shown(float luminance) { return smaller(larger(luminance, kBlack), 1.0f); }

/// The value of sRGB's curve (0 ... 1), but for what is nearly black.
LIPPMANN_INLINE float fast_code_of(float luminance) { return 1.055f * fast_pow(shown(luminance), 1.0f / 2.4f) - 0.055f; }

/// The scatter of which n samples would leave the error of having missed light of an `other` luminance.
LIPPMANN_INLINE float missed(float own, float other, float n, float weight) {
  const float error = fast_code_of(own + (other - own) / (n + 2.0f)) - fast_code_of(own);
  return std::abs(other - own) <= kSlight * own ? 0.0f : weight * error * error;
}

std::size_t whole_packets(std::size_t size) { return (size + kLanes - 1) / kLanes * kLanes; }

}  // namespace

void BlockEstimates::push_back(std::uint32_t of_pixel, float scatter_before) {
  const std::size_t e = size++;
  pixel[e] = of_pixel;
  before[e] = scatter_before;
  samples[e] = red[e] = green[e] = blue[e] = luminance[e] = square[e] = brightest[e] = open[e] = left_to_paths[e] = 0.0f;
}

void BlockEstimates::add(std::size_t e, Vec3f radiance, float opens, bool is_path) {
  const float y = lippmann::luminance(radiance);
  samples[e] += 1.0f;
  red[e] += radiance.x, green[e] += radiance.y, blue[e] += radiance.z;
  luminance[e] += y, square[e] += y * y;
  brightest[e] = std::max(brightest[e], y);
  open[e] += opens;
  left_to_paths[e] += is_path ? 1.0f : 0.0f;
}

void PathScatter::add(const BlockEstimates& block) {
  for (std::size_t e = 0; e < block.size; ++e) {
    const float share = block.left_to_paths[e] / block.samples[e];
    sum_ += share * std::min(block.scatter[kLanes + e], kMostScatter), count_ += share;
  }
}

LIPPMANN_MULTIVERSION void encode(BlockEstimates& block) {
  const std::size_t count = whole_packets(block.size);
#pragma GCC ivdep
  for (std::size_t e = 0; e < count; ++e) {
    const float n = block.samples[e], mean = block.luminance[e] / n;
    const float square = std::max(0.0f, block.square[e] / n - mean * mean);
    const float visible = shown(mean), slope = 1.055f * fast_pow(visible, 1.0f / 2.4f) / (2.4f * visible);
    block.mean[kLanes + e] = mean;
    const float clear = block.open[e] / n;
    block.clear[kLanes + e] = clear;
    const float others = std::max(n - 1.0f, 1.0f), most = block.brightest[e], rest = (block.luminance[e] - most) / others;
    block.sure[e] = slope * slope * std::max(0.0f, (block.square[e] - most * most) / others - rest * rest);
    block.scatter[kLanes + e] = (slope * slope * square + block.alpha_weight * clear * (1.0f - clear)) * n / (n - 1.0f);
  }
}

LIPPMANN_MULTIVERSION void find_wanted(float have, float error, float worst, BlockEstimates& block) {
  const auto size = static_cast<int>(block.size), count = static_cast<int>(whole_packets(block.size));
  const float weight = share_missed(have) * fast_pow(have, kErrorFall);
  const float inverse = 1.0f / (error * error), of_worst = 1.0f / worst;
  const bool has_say = have >= kOwnSamples;
  const int across = block.across;
  const float own_share = has_say ? have / (have + kNeighbours) : 0.0f;
#pragma GCC ivdep
  for (int e = 0; e < count; ++e) {
    const float* mean = block.mean + kLanes + e;
    const float* scatter = block.scatter + kLanes + e;
    const float* clear = block.clear + kLanes + e;
    const float own_mean = mean[0], own_scatter = scatter[0], own_clear = clear[0];
    float around = 0.0f, level = 0.0f, known = 0.0f, clear_around = 0.0f;
    float least = std::numeric_limits<float>::max(), most = 0.0f;
    const auto is_inside = [&](int step) LIPPMANN_INLINE_LAMBDA { return (e + step >= 0) & (e + step < size); };
    const auto look_at = [&](int step) LIPPMANN_INLINE_LAMBDA {
      const bool inside = is_inside(step);
      const float its_mean = mean[step];
      around += inside ? scatter[step] : 0.0f;
      level += inside ? shown(its_mean) : 0.0f;
      known += inside ? 1.0f : 0.0f;
      clear_around += inside ? clear[step] : 0.0f;
      least = smaller(least, inside ? its_mean : least);
      most = larger(most, inside ? its_mean : most);
    };
    look_at(-1), look_at(1), look_at(-across), look_at(across);
    const float each = 1.0f / larger(known, 1.0f);
    around *= each, level *= each, clear_around *= each;
    // What the pixel is taken to be like: itself, once it has a say, or else what is around it, as it is shown: a mean with
    // what is overexposed would be white.
    const float like = has_say ? own_mean : level, clear_like = has_say ? own_clear : clear_around;
    const auto edge_at = [&](int step)
                             LIPPMANN_INLINE_LAMBDA { return is_inside(step) ? std::abs(clear[step] - clear_like) : 0.0f; };
    const float edge = larger(larger(edge_at(-1), edge_at(1)), larger(edge_at(-across), edge_at(across))) / (have + 2.0f);
    const float sure = has_say ? block.sure[e] : 0.0f, before = block.before[e];
    float variance = known > 0.0f ? around + own_share * (own_scatter - around) : own_scatter;
    variance = larger(variance, sure);
    const float both_missed = missed(like, most, have, weight) + missed(like, least, have, weight);
    variance += known > 0.0f ? both_missed : 0.0f;
    variance += block.alpha_weight * weight * edge * edge;
    variance = larger(larger(variance, before), std::numeric_limits<float>::min());
    // Their paths are as good as independent: errors fall as the root of their number, and not faster.
    const float of_paths = std::sqrt(inverse * block.path_scatter * block.left_to_paths[e] / block.samples[e]);
    // Noise is no edge: it scatters by more than neighbours differ by, and is to be as strong as the mean allows.
    const float high = has_say ? larger(most, own_mean) : most, low = has_say ? smaller(least, own_mean) : least;
    const float step = fast_code_of(high) - fast_code_of(low), of_step = smaller(0.25f * step * step, kEdgeScatter);
    const float of_edge = larger(smaller(variance, of_step) * of_worst, std::numeric_limits<float>::min());
    const float of_light = larger(fast_pow(variance * inverse, kGrowth), fast_pow(of_edge, 1.0f / kErrorFall));
    block.wanted[e] = larger(of_light, of_paths);
  }
}

}  // namespace lippmann
