#include "radiance/gather_error.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/random.hpp"
#include "radiance/block_estimates.hpp"
#include "radiance/measured_codes.hpp"
#include "trace/trace_packets.hpp"

namespace lippmann {
namespace {

/// Where an error of pixels is asked for, means of patches may err by more than noise of pixels would: by almost three times
/// its deviation.
constexpr float kBlockSides = 8.0f;
/// Means of patches may err by so many times what those of paths do, or of pixels that err each by itself: 3 decibels.
constexpr float kBlockLoss = 2.0f;
/// No edge is expected to err by more than so many times what the mean may, squared (3 decibels), found by trial.
constexpr float kWorstOverMean = 2.0f;
/// Not to be below the goal by bad luck of the measurement.
constexpr float kMargin = 0.9f, kMixMargin = 0.85f;
/// PathErrors::exponent where it was not measured. That of noise alone, 1, would let a few paths that are mixed in spoil
/// pixels.
constexpr float kLikelyExponent = 1.2f;
/// What rounding to 8-bit codes adds by itself, (1 / 255)^2 / 12: to be better than that would be a waste.
constexpr float kInvisible = 1.28e-6f;
/// Half a code: means of patches that err by less look the same on any display.
constexpr float kInvisibleBlock = 0.25f / (255.0f * 255.0f);
/// Errors that are tried, each half the last. Coarser ones would be seen, even where a few bright specks of paths err by as
/// much.
constexpr float kCoarsest = 0.02f;
constexpr int kTrials = 7;
/// After this trial, one that is not better than this many times the last ends them.
constexpr int kLeastTrials = 2;
constexpr float kStalled = 0.95f;
/// Means that err by so many times what they may, surely, are wrong because of cells: more samples of pixels would not mend
/// them.
constexpr float kBlocksOfCells = 3.0f;
/// A share of the rays that paths need; above it they are traced: rays of single pixels take up to twice as long as those of
/// packets.
constexpr double kLargestShare = 0.7;
/// The share of the rays that paths need which mixing in some may take with all else.
constexpr double kMostMixed = 0.75;
/// More edges, and half the allowed error, are tried so often where means of patches err by too much, and kept where they leave
/// this much.
constexpr int kBlockTrials = 4;
constexpr float kHelpedByFiner = 0.8f;

/// With fewer than kLeastSamples, what sRGB's curve makes of noise would pass for an error.
int fewer_samples(int all, int fewer) {
  constexpr int kLeastSamples = 16;
  return std::min(all, std::max(all / fewer, kLeastSamples));
}

/// Between a trial that was not good enough and one with half its error that was: where the squared error is `enough`, on a
/// straight line in logarithms.
struct Trial {
  float error, squared_error;
  FrameError measured{};
};
float error_between(const Trial& coarse, const Trial& fine, float enough) {
  if (coarse.squared_error <= enough) return coarse.error;
  if (fine.squared_error >= enough) return fine.error;
  return coarse.error *
         std::exp2(-std::log(coarse.squared_error / enough) / std::log(coarse.squared_error / fine.squared_error));
}

/// What means of patches err by there.
float blocks_between(const Trial& coarse, const Trial& fine, float error) {
  const float a = coarse.measured.blocks, b = fine.measured.blocks;
  const float t = std::log(error / fine.error) / std::log(coarse.error / fine.error);
  return b * std::pow(a / b, std::clamp(t, 0.0f, 1.0f));
}

/// What is left of the squared error however many samples there are. Half the error takes 2^(2 / 2.6) times the samples, and
/// what these scatter falls as their number to the power 1.6 (block_estimates.cpp).
float error_of_cells(const Trial& coarse, const Trial& fine) {
  constexpr float kLeft = 0.426f;  // 2^(-1.6 * 2 / 2.6)
  return std::max(0.0f, fine.squared_error - kLeft * coarse.squared_error) / (1.0f - kLeft);
}

/// Whether means err by far too much, and no less than with coarser pixels.
bool blocks_need_cells(const Trial& coarse, const FrameError& found, float may) {
  constexpr float kHelpedByPixels = 0.8f;
  return found.blocks - 2.0f * found.block_uncertainty > kBlocksOfCells * may &&
         found.blocks > kHelpedByPixels * coarse.measured.blocks;
}

/// What an eye sees of pixels that err by `pixels` and whose means over a patch err by `blocks`, as far as patches tell: of
/// independent errors only own_share, of those that a patch has in common all.
PixelError error_at_eye(const PixelError& pixels, const PixelError& blocks, double own_share) {
  const auto own = static_cast<float>(own_share);
  const float in_common = (kBlockPixels * blocks.squared - pixels.squared) / (kBlockPixels - 1.0f);
  return {own * pixels.squared + (1.0f - own) * std::clamp(in_common, 0.0f, std::max(pixels.squared, 0.0f)),
          std::hypot(own * pixels.uncertainty, (1.0f - own) * blocks.uncertainty)};
}

/// The squared error of the mean of a channel over a patch. Errors of any two pixels, multiplied, tell what both are wrong
/// about alike, as their paths' noise has nothing to do with each other: so all paths of both sets may be held against every
/// pixel, and only a pixel's own square is taken of two sets apart.
class MeanError {
 public:
  void add(float picture, float first, float second) {
    const double v = static_cast<double>(picture), a = v - static_cast<double>(first), b = v - static_cast<double>(second);
    const double both = 0.5 * (a + b);
    sum_ += both, own_ += a * b - both * both;
    level_ += v - 0.5 * both, count_ += 1.0;
  }
  double of_codes() const {
    const double slope = slope_of_code(level_ / count_);
    return slope * slope * (sum_ * sum_ + own_) / (count_ * count_);
  }

 private:
  double sum_ = 0.0, own_ = 0.0, level_ = 0.0, count_ = 0.0;
};

}  // namespace

GatherMeasure::GatherMeasure(const Shot& shot, const TraceParams& trace, const ErrorGoal& goal, const MeasuredPlaces& places,
                             const Scatter& likely, const Workers& workers)
    : shot_(shot),
      trace_(trace),
      asked_(goal),
      blur_(shot.optics, goal.crosstalk_px),
      measured_(places),
      seed_(hash(trace.seed, trace.frame, places.salt)),
      workers_(workers.silent()) {
  const PacketSource source(shot.optics, shot.world_from_display, trace.order, SubPixel{}, shot.rows);
  patches_ = choose_patches(source, places.patches, likely, seed_);
  trace_patches(places.fewer);
  of_single_paths_ = difference(paths_[0].values, paths_[1].values);
  const auto share = static_cast<float>(share_of_independent());
  set_goal({share * of_single_paths_.squared, share * of_single_paths_.uncertainty});
}

double GatherMeasure::share_of_independent() const { return asked_.at_eye ? blur_.own_share() : 1.0; }

void GatherMeasure::choose_pixels_of(const Image& film, const Scatter& scatter) {
  if (pixels_ || !measured_.with_pixels()) return;
  pixels_.emplace(shot_, trace_, choose_pixels(film, measured_.pixels, scatter, seed_), 2, workers_);
  add(pixels_->counts(), counts_);
  of_single_paths_ = pixels_->of_paths();
  if (blur_.blurs()) {
    eye_.emplace(EyeWeights(blur_, film, workers_.pool), *pixels_, shot_, trace_, workers_);
    add(eye_->counts(), counts_);
  }
  set_goal(asked_.at_eye && eye_ ? eye_->of_paths() : of_single_paths_);
}

void GatherMeasure::set_goal(const PixelError& of_paths) {
  of_paths_ = of_paths;
  goal_.pixels = asked_.squared.value_or(std::max(of_paths_.squared, kInvisible));
  const float of_block =
      asked_.squared ? goal_.pixels / kBlockSides : std::max(of_single_paths_.squared, kInvisible) / kBlockPixels;
  goal_.blocks = std::max(kBlockLoss * of_block, kInvisibleBlock);
}

/// Edges are to be as smooth as those of paths, but not where most pixels are worse than that. An eye that sees neighbours as
/// one has no edges of pixels.
float GatherMeasure::worst_pixel() const {
  if (asked_.at_eye) return std::numeric_limits<float>::infinity();
  const float of_edges = asked_.squared ? 0.0f : kEdgeScatter / std::pow(static_cast<float>(trace_.spp), kErrorFall);
  return std::max(of_edges, kWorstOverMean * goal_.pixels);
}

/// Twice as many paths as a full render has: halves of a render would not do, as evenly spread samples are better than two sets
/// of half as many.
void GatherMeasure::trace_patches(int fewer) {
  Image film(film_size(shot_).x, film_size(shot_).y, 3);
  TraceParams params = trace_;
  params.spp = fewer_samples(trace_.spp, fewer);
  const bool in_halves = params.spp < trace_.spp;
  if (in_halves) params.spp = (params.spp + 1) / 2;
  const auto trace_with = [&](std::uint32_t seed_of_set) {
    params.seed = seed_of_set;
    add(trace_packets(shot_, params, patches_.wanted, workers_, film), counts_);
  };
  for (std::uint32_t set = 0; set < 2; ++set) {
    trace_with(hash(seed_, 0x70617468u, set));
    if (!in_halves) {
      paths_[set] = codes_of(light_at(film, patches_.pixels));
      continue;
    }
    const std::vector<float> first = light_at(film, patches_.pixels);
    trace_with(hash(seed_, 0x68616c66u, set));
    const std::vector<float> second = light_at(film, patches_.pixels);
    paths_[set] = codes_of_halves(first, second);
    of_halves_ += 0.5f * difference(codes_of(first).values, codes_of(second).values).squared;
  }
  samples_of_half_ = params.spp;
  rays_of_paths_ = 0.5 * static_cast<double>(counts_.total()) * trace_.spp / fewer_samples(trace_.spp, fewer);
}

/// Half the squared difference of codes of the patches' pixels.
PixelError GatherMeasure::difference(const std::vector<float>& a, const std::vector<float>& b) const {
  MeanOf pixels;
  for (std::size_t p = 0; p < patches_.weights.size(); ++p) {
    double sum = 0.0;
    const std::size_t begin = 3 * patches_.begin[p], end = 3 * patches_.begin[p + 1];
    for (std::size_t i = begin; i < end; ++i) {
      const auto d = static_cast<double>(a[i] - b[i]);
      sum += 0.5 * d * d;
    }
    pixels.add(patches_.weights[p] * sum / static_cast<double>(end - begin));
  }
  return {pixels.mean(), pixels.uncertainty()};
}

GatherMeasure::Codes GatherMeasure::codes_of(const std::vector<float>& light) const {
  Codes codes{light, light};
  for (float& v : codes.values) v = code_of(v);
  for (float& v : codes.shown) v = shown_light(v);
  return codes;
}

/// sRGB's curve makes what is noisy darker on average, and so does the white that brighter light is cut off at: of half as many
/// samples by twice as much, and so of all by the difference between these two (jackknife; M. H. Quenouille, "Notes on bias in
/// estimation", Biometrika 43, 1956).
GatherMeasure::Codes GatherMeasure::codes_of_halves(const std::vector<float>& first, const std::vector<float>& second) const {
  std::vector<float> light(first.size());
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = 0.5f * (first[i] + second[i]);
  Codes codes = codes_of(light);
  for (std::size_t i = 0; i < light.size(); ++i) {
    codes.values[i] = 2.0f * codes.values[i] - 0.5f * (code_of(first[i]) + code_of(second[i]));
    codes.shown[i] = 2.0f * codes.shown[i] - 0.5f * (shown_light(first[i]) + shown_light(second[i]));
  }
  return codes;
}

/// Means are those of the light that is shown, as lenses and eyes average it: those of codes would be darker the noisier pixels
/// are.
FrameError GatherMeasure::error_of_patches(const Image& film) const {
  const Codes codes = codes_of(light_at(film, patches_.pixels));
  MeanOf pixels, blocks;  // both by patch: pixels of one err alike
  for (std::size_t p = 0; p < patches_.weights.size(); ++p) {
    double sum = 0.0;
    MeanError means[3];
    const std::size_t begin = 3 * patches_.begin[p], end = 3 * patches_.begin[p + 1];
    for (std::size_t i = begin; i < end; ++i) {
      sum += static_cast<double>(codes.values[i] - paths_[0].values[i]) *
             static_cast<double>(codes.values[i] - paths_[1].values[i]);
      means[i % 3].add(codes.shown[i], paths_[0].shown[i], paths_[1].shown[i]);
    }
    const double weight = patches_.weights[p];
    pixels.add(weight * sum / static_cast<double>(end - begin));
    blocks.add(weight * (means[0].of_codes() + means[1].of_codes() + means[2].of_codes()) / 3.0);
  }
  const PixelError single{pixels.mean(), pixels.uncertainty()}, means{blocks.mean(), blocks.uncertainty()};
  FrameError error{0.0f, means.squared, 0.0f, means.uncertainty};
  set_pixels(single, error_at_eye(single, means, blur_.own_share()), error);
  return at_least_some(error);
}

FrameError GatherMeasure::error_of(const Image& film) const {
  FrameError error = error_of_patches(film);
  if (!pixels_) return error;
  const PixelError single = pixels_->error_of(film);
  set_pixels(single, eye_ ? eye_->error_of(film) : single, error);
  return at_least_some(error);
}

void GatherMeasure::set_pixels(const PixelError& single, const PixelError& at_eye, FrameError& error) const {
  const PixelError& judged = asked_.at_eye ? at_eye : single;
  error.pixels = judged.squared, error.uncertainty = judged.uncertainty;
  error.other = asked_.at_eye ? single : at_eye;
}

/// Nothing is known so well that there could be no error at all.
FrameError GatherMeasure::at_least_some(FrameError error) const {
  error.pixels = std::max(error.pixels, 0.02f * goal_.pixels);
  error.blocks = std::max(error.blocks, 0.02f * goal_.blocks);
  error.other.squared = std::max(error.other.squared, 0.02f * goal_.pixels);
  return error;
}

FrameError GatherMeasure::gather(const GatherSources& sources, const GatherEffort& effort, const GatherHistory& history,
                                 std::uint32_t frame) {
  Image film;
  TraceParams trace = trace_;
  trace.frame += frame;
  const RayCounts rays = gather_frame(sources, {trace, effort}, patches_.wanted, history, workers_, {film});
  add(rays, counts_);
  rays_of_last_ = static_cast<double>(rays.total());
  last_ = error_of_patches(film);
  return last_;
}

std::optional<GatherPlan> GatherMeasure::plan(const GatherSources& sources) {
  const float enough = kMargin * goal_.pixels;
  std::optional<Trial> coarse, fine;  // the finest that was not good enough, the coarsest that was
  FrameError measured;
  double rays_of_fine = 0.0;
  EdgesToPaths edges = EdgesToPaths::kNone;
  const float worst = worst_pixel();
  while (!coarse || !fine) {
    const float error = std::ldexp(kCoarsest, -next_trial_);
    measured = gather(sources, {.error = error, .edges = edges, .worst = worst}, {});
    const Trial found{error, measured.pixels, measured};
    if (found.squared_error <= enough) {
      fine = found, rays_of_fine = rays_of_last_;
      if (next_trial_ == 0) break;
      if (!coarse) --next_trial_;
    } else {
      if (coarse && blocks_need_cells(*coarse, measured, goal_.blocks)) {
        GatherPlan plan{error, error, edges, {}, worst, 1.0f, measured, rays_of_last_ / rays_of_paths_};
        refine_for_blocks(sources, plan);
        return plan;
      }
      const bool stalled = coarse && next_trial_ > kLeastTrials && found.squared_error > kStalled * coarse->squared_error;
      coarse = found;
      if (fine) break;
      if (rays_of_last_ > kLargestShare * rays_of_paths_) return std::nullopt;
      if (stalled && edges == EdgesToPaths::kNone) {
        edges = EdgesToPaths::kFaint;
        continue;
      }
      if (stalled || next_trial_ + 1 == kTrials) return std::nullopt;
      ++next_trial_;
    }
  }
  if (rays_of_fine > kLargestShare * rays_of_paths_) return std::nullopt;
  const float error = coarse ? error_between(*coarse, *fine, enough) : fine->error;
  GatherPlan plan{error, error, edges, {}, worst, coarse ? error_of_cells(*coarse, *fine) / enough : 0.0f, measured};
  if (coarse) plan.expected.pixels = enough, plan.expected.blocks = blocks_between(*coarse, *fine, error);
  plan.share_of_rays = rays_of_fine / rays_of_paths_;
  refine_for_blocks(sources, plan);
  return plan;
}

std::optional<PathMix> GatherMeasure::mix_for(const FrameError& found, double share_of_rays) const {
  const MixedErrors may{kMixMargin * goal_.pixels, kMixMargin * goal_.blocks};
  const int most = static_cast<int>((kMostMixed - share_of_rays) * trace_.spp);
  return lippmann::mix_for({found.pixels, found.blocks}, path_errors(), may, most);
}

/// Those of pixels have nothing to do with each other.
PathErrors GatherMeasure::path_errors() const {
  return PathErrors::with({of_paths_.squared, of_single_paths_.squared / kBlockPixels}, trace_.spp, path_exponent());
}

/// By what halves of the sets err, and a whole picture.
float GatherMeasure::path_exponent() const {
  if (!(of_halves_ > 0.0f && of_single_paths_.squared > 0.0f)) return kLikelyExponent;
  const float times = static_cast<float>(trace_.spp) / static_cast<float>(samples_of_half_);
  return std::clamp(std::log(of_halves_ / of_single_paths_.squared) / std::log(times), 1.0f, 2.0f);
}

FrameError GatherMeasure::mixed(const PathMix& mix, const FrameError& cached) const {
  const MixedErrors errors = errors_of(mix, {cached.pixels, cached.blocks}, path_errors());
  FrameError found = cached;
  found.pixels = errors.pixels, found.blocks = errors.blocks;
  found.block_uncertainty *= (1.0f - mix.weight) * (1.0f - mix.weight);
  return found;
}

FrameError GatherMeasure::without(const PathMix& mix, const FrameError& found) const {
  if (mix.samples == 0) return found;
  const MixedErrors of_paths = errors_of(mix, {}, path_errors());
  const float part = (1.0f - mix.weight) * (1.0f - mix.weight);
  FrameError cached = found;
  cached.pixels = (found.pixels - of_paths.pixels) / part, cached.blocks = (found.blocks - of_paths.blocks) / part;
  cached.block_uncertainty = found.block_uncertainty / part;
  return at_least_some(cached);
}

/// Means of patches may err by too much where pixels do not: more edges are left to paths, and then there are more samples, as
/// long as they help.
void GatherMeasure::refine_for_blocks(const GatherSources& sources, GatherPlan& plan) {
  bool edges_help = true;
  for (int trial = 0; trial < kBlockTrials && plan.expected.blocks > goal_.blocks; ++trial) {
    GatherPlan finer = plan;
    const bool is_of_edges = edges_help && plan.edges != EdgesToPaths::kFaint;
    if (is_of_edges)
      finer.edges = plan.edges == EdgesToPaths::kNone ? EdgesToPaths::kVisible : EdgesToPaths::kFaint;
    else
      finer.error = finer.error_alone = 0.5f * plan.error_alone;
    finer.expected = gather(sources, finer.effort_alone(), {});
    const bool helps =
        rays_of_last_ <= kLargestShare * rays_of_paths_ && finer.expected.blocks <= kHelpedByFiner * plan.expected.blocks;
    if (!helps && !is_of_edges) return;
    finer.share_of_rays = rays_of_last_ / rays_of_paths_;
    if (helps)
      plan = finer;
    else
      edges_help = false;
  }
}

void GatherMeasure::plan_frames_in_a_row(const GatherSources& sources, GatherPlan& plan) {
  plan.error = error_in_a_row(sources, plan.effort_alone(), kMargin * goal_.pixels);
}

/// The error of frames that know the one before, if those that do not need `alone` to be good enough.
float GatherMeasure::error_in_a_row(const GatherSources& sources, const GatherEffort& alone, float enough) {
  const auto with = [&](float error) { return GatherEffort{error, alone.edges, alone.mix, alone.worst}; };
  Scatter scatter;
  gather(sources, alone, {nullptr, &scatter}, 1);
  const Scatter before = smoothed(scatter, sources.shot.optics, workers_.pool);
  Trial fine{alone.error, gather(sources, alone, {&before, nullptr}).pixels};
  while (fine.squared_error <= enough && fine.error < kCoarsest) {
    const Trial coarse{2.0f * fine.error, gather(sources, with(2.0f * fine.error), {&before, nullptr}).pixels};
    if (coarse.squared_error > enough) return error_between(coarse, fine, enough);
    fine = coarse;
  }
  return fine.error;
}

FrameError GatherMeasure::check(const GatherSources& sources, const GatherEffort& effort, const Scatter& before) {
  return gather(sources, effort, {before.empty() ? nullptr : &before, nullptr});
}

GatherMeasure::Timed GatherMeasure::plan_within(const GatherSources& sources, double seconds) {
  using Clock = std::chrono::steady_clock;
  GatherPlan last;
  double last_seconds = 0.0;
  Scatter before, scatter;
  for (int trial = 0; trial < kTrials; ++trial) {
    const float error = std::ldexp(kCoarsest, -trial);
    const Clock::time_point start = Clock::now();
    const FrameError measured = gather(sources, {.error = error}, {&before, &scatter});
    const double taken = std::chrono::duration<double>(Clock::now() - start).count() / patches_.of_frame;
    before = smoothed(scatter, sources.shot.optics, workers_.pool);
    const GatherPlan found{.error = error, .error_alone = error, .expected = measured};
    if (taken > seconds) {
      if (trial == 0) return {found, true};
      // Between the last two, on a straight line in logarithms.
      const double t = taken > last_seconds ? std::log(seconds / last_seconds) / std::log(taken / last_seconds) : 0.0;
      const auto part = static_cast<float>(std::clamp(t, 0.0, 1.0));
      const float between = last.error * std::exp2(-part);
      FrameError expected = measured;
      expected.pixels = last.expected.pixels * std::pow(measured.pixels / last.expected.pixels, part);
      return {{.error = between, .error_alone = between, .expected = expected}, true};
    }
    if (measured.pixels <= kInvisible || (trial > kLeastTrials && measured.pixels > kStalled * last.expected.pixels))
      return {found, false};
    last = found, last_seconds = taken;
  }
  return {last, false};
}

}  // namespace lippmann
