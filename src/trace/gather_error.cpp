#include "trace/gather_error.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "core/random.hpp"
#include "image/encode.hpp"
#include "trace/trace_packets.hpp"

namespace lippmann {
namespace {

/// Packets of a patch: 64 pixels.
constexpr std::size_t kPatch = 4;
constexpr float kPatchPixels = 64.0f;
/// Where an error of pixels is asked for, means of patches may err by more than noise of pixels would: by almost three times
/// its deviation.
constexpr float kPatchSides = 8.0f;
/// However small the frame.
constexpr std::size_t kLeastPatches = 12;
/// Means of patches may err by so many times what those of paths do, or of pixels that err each by itself: 3 decibels.
constexpr float kBlockLoss = 2.0f;
/// Not to be below the goal by bad luck of the measurement.
constexpr float kMargin = 0.9f;
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
/// Of the rays that paths need; above it they are traced.
constexpr double kLargestShare = 0.7;
/// Half the allowed error is tried so often where means of patches err by too much, and kept where it leaves this much.
constexpr int kBlockTrials = 3;
constexpr float kHelped = 0.8f;

float encoded(float linear) { return static_cast<float>(srgb_from_linear(std::clamp(linear, 0.0f, 1.0f))); }

/// A patch, and how much its error counts for that of the frame.
struct Patch {
  std::size_t first;  ///< packet
  double weight = 1.0;
};

/// Where errors are likely to be large, patches are chosen up to 1 + 1 / this times as often as elsewhere.
constexpr double kEvenShare = 0.5;

/// One patch of each of as many parts of the frame, drawn within them by a hash, so that they do not line up with lenses. Parts
/// are alike in what errors are likely to be (importance sampling, stratified).
std::vector<Patch> some_patches(const FramePackets& frame, const HeldOut& held_out, std::uint32_t seed,
                                const std::vector<double>& likely) {
  const std::size_t per_strip = (frame.per_strip + kPatch - 1) / kPatch, patches = frame.strips * per_strip;
  const std::size_t some =
      std::clamp(patches / held_out.small_part, kLeastPatches, std::max(held_out.patches, patches / held_out.large_part));
  const std::size_t parts = std::min(some, patches);
  double all = 0.0;
  for (const double l : likely) all += l;
  const double mean = all / static_cast<double>(std::max<std::size_t>(patches, 1));
  const auto share = [&](std::size_t patch) {
    return mean > 0.0 ? (likely[patch] / mean + kEvenShare) / (1.0 + kEvenShare) : 1.0;
  };
  std::vector<Patch> chosen;
  std::size_t patch = 0;
  double before = 0.0;  // shares of all patches before this one
  for (std::size_t part = 0; part < parts; ++part) {
    const double u = unit_float(hash(seed, static_cast<std::uint32_t>(part)));
    const double at = (static_cast<double>(part) + u) * static_cast<double>(patches) / static_cast<double>(parts);
    while (patch + 1 < patches && before + share(patch) <= at) before += share(patch++);
    const Patch next{patch / per_strip * frame.per_strip + patch % per_strip * kPatch, 1.0 / share(patch)};
    if (!chosen.empty() && chosen.back().first == next.first)
      chosen.back().weight += next.weight;  // it stands for two parts
    else
      chosen.push_back(next);
  }
  return chosen;
}

/// Mean scatter of the pixels of all patches; nothing where it is not known.
std::vector<double> by_patch(const Scatter& likely, const FramePackets& frame, const Optics& optics,
                             const Affine3f& world_from_display, RayOrder order) {
  const std::size_t per_strip = (frame.per_strip + kPatch - 1) / kPatch;
  std::vector<double> means(frame.strips * per_strip, 0.0);
  if (likely.empty()) return means;
  for_each_pixel(optics, world_from_display, order, [&](std::size_t packet, std::uint32_t pixel) {
    const std::size_t patch = packet / frame.per_strip * per_strip + packet % frame.per_strip / kPatch;
    means[patch] += std::max(0.0, static_cast<double>(likely[pixel]));
  });
  return means;
}

/// Between a trial that was not good enough and one with half its error that was: where the squared error is `enough`, on a
/// straight line in logarithms.
struct Trial {
  float error, squared_error;
};
float error_between(const Trial& coarse, const Trial& fine, float enough) {
  if (coarse.squared_error <= enough) return coarse.error;
  if (fine.squared_error >= enough) return fine.error;
  return coarse.error *
         std::exp2(-std::log(coarse.squared_error / enough) / std::log(coarse.squared_error / fine.squared_error));
}

/// What is left of the squared error however many samples there are. Half the error takes 2^(2 / 2.6) times the samples, and
/// what these scatter falls as their number to the power 1.6 (block_estimates.cpp).
float error_of_cells(const Trial& coarse, const Trial& fine) {
  constexpr float kLeft = 0.426f;  // 2^(-1.6 * 2 / 2.6)
  return std::max(0.0f, fine.squared_error - kLeft * coarse.squared_error) / (1.0f - kLeft);
}

/// The mean of some values, and its standard deviation.
struct MeanOf {
  double sum = 0.0, squares = 0.0, count = 0.0;
  void add(double v) { sum += v, squares += v * v, count += 1.0; }
  float mean() const { return static_cast<float>(sum / std::max(count, 1.0)); }
  float uncertainty() const {
    const double m = sum / std::max(count, 1.0);
    return static_cast<float>(std::sqrt(std::max(0.0, squares / std::max(count, 1.0) - m * m) / std::max(count - 1.0, 1.0)));
  }
};

/// (a - b) (c - d), the mean of three channels.
double product(Vec3f a, Vec3f b, Vec3f c, Vec3f d) {
  const Vec3f p = (a - b) * (c - d);
  return (static_cast<double>(p.x) + static_cast<double>(p.y) + static_cast<double>(p.z)) / 3.0;
}

}  // namespace

GatherMeasure::GatherMeasure(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display,
                             const TraceParams& trace, std::optional<float> goal, const HeldOut& held_out,
                             const Scatter& likely, const ThreadPool& pool)
    : trace_(trace), has_goal_(goal.has_value()), pool_(pool) {
  const FramePackets packets = packets_in_frame(optics, world_from_display, trace.order);
  const std::uint32_t seed = hash(trace.seed, trace.frame);
  wanted_.assign(packets.strips * packets.per_strip, 0);
  patch_begin_.push_back(0);
  const std::vector<double> likely_errors = by_patch(likely, packets, optics, world_from_display, trace.order);
  for (const auto& [first, weight] : some_patches(packets, held_out, seed, likely_errors)) {
    const std::size_t strip = first / packets.per_strip, end = std::min(first + kPatch, (strip + 1) * packets.per_strip);
    std::fill(wanted_.begin() + static_cast<std::ptrdiff_t>(first), wanted_.begin() + static_cast<std::ptrdiff_t>(end), 1);
    append_pixels(optics, world_from_display, trace.order, first, end, places_);
    if (places_.size() > patch_begin_.back()) patch_begin_.push_back(places_.size()), weights_.push_back(weight);
  }
  of_frame_ = static_cast<double>(std::count(wanted_.begin(), wanted_.end(), 1)) /
              static_cast<double>(std::max<std::size_t>(wanted_.size(), 1));
  // Twice as many paths as a full render has: halves of a render would not do, as evenly spread samples are better than two
  // sets of half as many.
  const Context quiet;  // a few patches are no progress of the frame
  Image film(optics.panel.width, optics.panel.height, 3);
  for (std::uint32_t set = 0; set < 2; ++set) {
    TraceParams params = trace;
    params.seed = hash(seed, 0x70617468u, set);
    add(trace_packets(scene, optics, world_from_display, params, wanted_, pool, quiet, film), counts_);
    paths_[set] = codes_at_places(film);
  }
  rays_of_paths_ = 0.5 * static_cast<double>(counts_.total());
  MeanOf pixels, blocks;
  for (std::size_t p = 0; p < weights_.size(); ++p) {
    const Vec3f a = paths_[0].means[p], b = paths_[1].means[p];
    blocks.add(weights_[p] * 0.5 * product(a, b, a, b));
    double sum = 0.0;
    const std::size_t begin = 3 * patch_begin_[p], end = 3 * patch_begin_[p + 1];
    for (std::size_t i = begin; i < end; ++i) {
      const auto d = static_cast<double>(paths_[0].values[i] - paths_[1].values[i]);
      sum += 0.5 * d * d;
    }
    pixels.add(weights_[p] * sum / static_cast<double>(end - begin));
  }
  of_paths_.pixels = pixels.mean(), of_paths_.blocks = blocks.mean();
  goal_.pixels = goal.value_or(std::max(of_paths_.pixels, kInvisible));
  const float more = of_paths_.pixels > 0.0f ? goal_.pixels / of_paths_.pixels : 1.0f;
  const float independent = goal_.pixels / (goal ? kPatchSides : kPatchPixels);
  goal_.blocks = std::max({kBlockLoss * more * of_paths_.blocks, kBlockLoss * independent, kInvisibleBlock});
}

GatherMeasure::Codes GatherMeasure::codes_at_places(const Image& film) const {
  Codes codes;
  for (const std::uint32_t pixel : places_)
    for (std::size_t c = 0; c < 3; ++c) codes.values.push_back(encoded(film.data[3 * static_cast<std::size_t>(pixel) + c]));
  for (std::size_t p = 0; p + 1 < patch_begin_.size(); ++p) {
    Vec3f sum(0.0f);
    for (std::size_t i = patch_begin_[p]; i < patch_begin_[p + 1]; ++i)
      sum += Vec3f(codes.values[3 * i], codes.values[3 * i + 1], codes.values[3 * i + 2]);
    codes.means.push_back(sum / static_cast<float>(patch_begin_[p + 1] - patch_begin_[p]));
  }
  return codes;
}

FrameError GatherMeasure::error_of(const Image& film) const {
  const Codes codes = codes_at_places(film);
  MeanOf pixels, blocks;  // both by patch: pixels of one err alike
  for (std::size_t p = 0; p < codes.means.size(); ++p) {
    blocks.add(weights_[p] * product(codes.means[p], paths_[0].means[p], codes.means[p], paths_[1].means[p]));
    double sum = 0.0;
    const std::size_t begin = 3 * patch_begin_[p], end = 3 * patch_begin_[p + 1];
    for (std::size_t i = begin; i < end; ++i)
      sum += static_cast<double>(codes.values[i] - paths_[0].values[i]) *
             static_cast<double>(codes.values[i] - paths_[1].values[i]);
    pixels.add(weights_[p] * sum / static_cast<double>(end - begin));
  }
  // Nothing is known so well that there could be no error at all.
  return {std::max(pixels.mean(), 0.02f * goal_.pixels), std::max(blocks.mean(), 0.02f * goal_.blocks), pixels.uncertainty(),
          blocks.uncertainty()};
}

int GatherMeasure::path_samples() const {
  constexpr float kMostMore = 64.0f;
  const float more = has_goal_ ? std::clamp(of_paths_.pixels / std::max(goal_.pixels, 1e-12f), 1.0f, kMostMore) : 1.0f;
  return static_cast<int>(std::ceil(more * static_cast<float>(trace_.spp)));
}

FrameError GatherMeasure::gather(const GatherSources& sources, float error, const GatherHistory& history, std::uint32_t frame) {
  const Context quiet;
  Image film;
  TraceParams trace = trace_;
  trace.frame += frame;
  const RayCounts rays = gather_frame(sources, {trace, error}, wanted_, history, pool_, quiet, film);
  add(rays, counts_);
  rays_of_last_ = static_cast<double>(rays.total());
  last_ = error_of(film);
  return last_;
}

std::optional<GatherPlan> GatherMeasure::plan(const GatherSources& sources) {
  const float enough = kMargin * goal_.pixels;
  std::optional<Trial> coarse, fine;  // the finest that was not good enough, the coarsest that was
  FrameError measured;
  double rays_of_fine = 0.0;
  while (!coarse || !fine) {
    const float error = std::ldexp(kCoarsest, -next_trial_);
    measured = gather(sources, error, {});
    const Trial found{error, measured.pixels};
    if (found.squared_error <= enough) {
      fine = found, rays_of_fine = rays_of_last_;
      if (next_trial_ == 0) break;
      if (!coarse) --next_trial_;
    } else {
      const bool stalled = coarse && next_trial_ > kLeastTrials && found.squared_error > kStalled * coarse->squared_error;
      coarse = found;
      if (fine) break;
      if (rays_of_last_ > kLargestShare * rays_of_paths_ || stalled || next_trial_ + 1 == kTrials) return std::nullopt;
      ++next_trial_;
    }
  }
  if (rays_of_fine > kLargestShare * rays_of_paths_) return std::nullopt;
  const float error = coarse ? error_between(*coarse, *fine, enough) : fine->error;
  GatherPlan plan{error, error, coarse ? error_of_cells(*coarse, *fine) / enough : 0.0f, measured};
  if (coarse) plan.expected.pixels = enough;
  refine_for_blocks(sources, plan);
  return plan;
}

/// Means of patches may err by too much where pixels do not: more samples, as long as they help.
void GatherMeasure::refine_for_blocks(const GatherSources& sources, GatherPlan& plan) {
  for (int trial = 0; trial < kBlockTrials && plan.expected.blocks > goal_.blocks; ++trial) {
    const FrameError finer = gather(sources, 0.5f * plan.error_alone, {});
    if (rays_of_last_ > kLargestShare * rays_of_paths_ || finer.blocks > kHelped * plan.expected.blocks) return;
    plan.error = plan.error_alone = 0.5f * plan.error_alone;
    plan.expected = finer;
  }
}

void GatherMeasure::plan_frames_in_a_row(const GatherSources& sources, GatherPlan& plan) {
  plan.error = error_in_a_row(sources, plan.error_alone, kMargin * goal_.pixels);
}

/// Of frames that know the one before, if those that do not need `error` to be good enough.
float GatherMeasure::error_in_a_row(const GatherSources& sources, float error, float enough) {
  Scatter scatter;
  gather(sources, error, {nullptr, &scatter}, 1);
  const Scatter before = smoothed(scatter, sources.optics, pool_);
  Trial fine{error, gather(sources, error, {&before, nullptr}).pixels};
  while (fine.squared_error <= enough && fine.error < kCoarsest) {
    const Trial coarse{2.0f * fine.error, gather(sources, 2.0f * fine.error, {&before, nullptr}).pixels};
    if (coarse.squared_error > enough) return error_between(coarse, fine, enough);
    fine = coarse;
  }
  return fine.error;
}

FrameError GatherMeasure::check(const GatherSources& sources, float error, const Scatter& before) {
  return gather(sources, error, {before.empty() ? nullptr : &before, nullptr});
}

GatherMeasure::Timed GatherMeasure::plan_within(const GatherSources& sources, double seconds) {
  using Clock = std::chrono::steady_clock;
  GatherPlan last;
  double last_seconds = 0.0;
  Scatter before, scatter;
  for (int trial = 0; trial < kTrials; ++trial) {
    const float error = std::ldexp(kCoarsest, -trial);
    const Clock::time_point start = Clock::now();
    const FrameError measured = gather(sources, error, {&before, &scatter});
    const double taken = std::chrono::duration<double>(Clock::now() - start).count() / of_frame_;
    before = smoothed(scatter, sources.optics, pool_);
    const GatherPlan found{error, error, 0.0f, measured};
    if (taken > seconds) {
      if (trial == 0) return {found, true};
      // Between the last two, on a straight line in logarithms.
      const double t = taken > last_seconds ? std::log(seconds / last_seconds) / std::log(taken / last_seconds) : 0.0;
      const auto part = static_cast<float>(std::clamp(t, 0.0, 1.0));
      const float between = last.error * std::exp2(-part);
      FrameError expected = measured;
      expected.pixels = last.expected.pixels * std::pow(measured.pixels / last.expected.pixels, part);
      return {{between, between, 0.0f, expected}, true};
    }
    if (measured.pixels <= kInvisible || (trial > kLeastTrials && measured.pixels > kStalled * last.expected.pixels))
      return {found, false};
    last = found, last_seconds = taken;
  }
  return {last, false};
}

}  // namespace lippmann
