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

/// Patches of neighbouring packets are measured: small ones, as what lies near by errs alike.
constexpr std::size_t kPatch = 2;
/// So many: enough for the mean error of a frame to be known within a decibel.
constexpr std::size_t kMeasuredPatches = 192;
/// Of a small frame no more than one of so many, but some; of a large one no fewer than one of so many.
constexpr std::size_t kLeastPatches = 8;
constexpr std::size_t kLeastPart = 16, kUsualPart = 96;
/// Not to be below the goal by bad luck of the measurement.
constexpr float kMargin = 0.9f;
/// What rounding to 8-bit codes adds by itself, (1 / 255)^2 / 12: to be better than that would be a waste.
constexpr float kInvisible = 1.28e-6f;
/// Errors that are tried, each half the last.
constexpr float kCoarsest = 0.08f;
constexpr int kTrials = 9;
/// After this trial, one that is not better than this many times the last ends them.
constexpr int kLeastTrials = 4;
constexpr float kStalled = 0.95f;
/// Of the rays that paths need; above it they are traced.
constexpr double kLargestShare = 0.9;

float encoded(float linear) { return static_cast<float>(srgb_from_linear(std::clamp(linear, 0.0f, 1.0f))); }

/// By packet: one patch of each of as many equal parts of the frame, hashed so that they do not line up with lenses.
std::vector<std::uint8_t> some_packets(const FramePackets& frame, std::uint32_t seed) {
  std::vector<std::uint8_t> wanted(frame.strips * frame.per_strip, 0);
  const std::size_t per_strip = (frame.per_strip + kPatch - 1) / kPatch, patches = frame.strips * per_strip;
  const std::size_t some = std::clamp(patches / kLeastPart, kLeastPatches, std::max(kMeasuredPatches, patches / kUsualPart));
  const std::size_t parts = std::min(some, patches);
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t begin = part * patches / parts, count = (part + 1) * patches / parts - begin;
    const std::size_t patch = begin + hash(seed, static_cast<std::uint32_t>(part)) % count;
    const std::size_t first = patch % per_strip * kPatch, strip = patch / per_strip * frame.per_strip;
    for (std::size_t p = first; p < std::min(first + kPatch, frame.per_strip); ++p) wanted[strip + p] = 1;
  }
  return wanted;
}

float mean_square(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += d * d;
  }
  return a.empty() ? 0.0f : static_cast<float>(sum / static_cast<double>(a.size()));
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

/// As sRGB's codes (0 ... 1).
std::vector<float> at(const std::vector<std::size_t>& places, const Image& film) {
  std::vector<float> values;
  values.reserve(places.size());
  for (const std::size_t i : places) values.push_back(encoded(film.data[i]));
  return values;
}

}  // namespace

GatherMeasure::GatherMeasure(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display,
                             const TraceParams& trace, std::optional<float> goal, const ThreadPool& pool)
    : trace_(trace),
      has_goal_(goal.has_value()),
      pool_(pool),
      wanted_(some_packets(packets_in_frame(optics, world_from_display, trace.order), hash(trace.seed, trace.frame))) {
  of_frame_ = static_cast<double>(std::count(wanted_.begin(), wanted_.end(), 1)) /
              static_cast<double>(std::max<std::size_t>(wanted_.size(), 1));
  // Twice as many paths as a full render has, with other random numbers: what they differ by tells the error of each, and of
  // their mean. Halves of a render would not do: evenly spread samples are better than two sets of half as many.
  const Context quiet;  // a few patches are no progress of the frame
  Image film(optics.panel.width, optics.panel.height, 3);
  std::fill(film.data.begin(), film.data.end(), std::nanf(""));
  std::array<std::vector<float>, 2> sets;
  for (std::uint32_t set = 0; set < 2; ++set) {
    TraceParams params = trace;
    params.seed = hash(trace.seed, 0x70617468u, set);
    add(trace_packets(scene, optics, world_from_display, params, wanted_, pool, quiet, film), counts_);
    if (set == 0)
      for (std::size_t i = 0; i < film.data.size(); ++i)
        if (!std::isnan(film.data[i])) places_.push_back(i);
    sets[set] = at(places_, film);
  }
  rays_of_paths_ = 0.5 * static_cast<double>(counts_.total());
  squared_error_of_paths_ = 0.5f * mean_square(sets[0], sets[1]);
  squared_goal_ = goal.value_or(std::max(squared_error_of_paths_, kInvisible));
  // The mean of the codes, as a single bright path may hide in one set's, but not in the mean light's.
  for (std::size_t i = 0; i < places_.size(); ++i) paths_.push_back(0.5f * (sets[0][i] + sets[1][i]));
}

int GatherMeasure::path_samples() const {
  constexpr float kMostMore = 64.0f;
  const float more = has_goal_ ? std::clamp(squared_error_of_paths_ / std::max(squared_goal_, 1e-12f), 1.0f, kMostMore) : 1.0f;
  return static_cast<int>(std::ceil(more * static_cast<float>(trace_.spp)));
}

float GatherMeasure::squared_error(const Image& film) const {
  // The paths' own error is none of ours. Nor is it known so well that the rest could be nothing.
  return std::max(mean_square(at(places_, film), paths_) - 0.5f * squared_error_of_paths_, 0.02f * squared_goal_);
}

float GatherMeasure::gather(const GatherSources& sources, float error, const GatherHistory& history, std::uint32_t frame) {
  const Context quiet;
  Image film;
  TraceParams trace = trace_;
  trace.frame += frame;
  const RayCounts rays = gather_frame(sources, {trace, error}, wanted_, history, pool_, quiet, film);
  add(rays, counts_);
  rays_of_last_ = static_cast<double>(rays.total());
  return squared_error(film);
}

std::optional<GatherPlan> GatherMeasure::plan(const GatherSources& sources) {
  const float enough = kMargin * squared_goal_;
  std::optional<Trial> coarse, fine;  // the finest that was not good enough, the coarsest that was
  double rays_of_fine = 0.0;
  while (!coarse || !fine) {
    const float error = std::ldexp(kCoarsest, -next_trial_);
    const Trial found{error, gather(sources, error, {})};
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
  if (!coarse) return GatherPlan{fine->error, fine->error, 0.0f, fine->squared_error};
  const float error = error_between(*coarse, *fine, enough);
  return GatherPlan{error, error, error_of_cells(*coarse, *fine) / enough, enough};
}

void GatherMeasure::plan_frames_in_a_row(const GatherSources& sources, GatherPlan& plan) {
  plan.error = error_in_a_row(sources, plan.error_alone, kMargin * squared_goal_);
}

/// Of frames that know the one before, if those that do not need `error` to be good enough.
float GatherMeasure::error_in_a_row(const GatherSources& sources, float error, float enough) {
  Scatter scatter;
  gather(sources, error, {nullptr, &scatter}, 1);
  const Scatter before = smoothed(scatter, sources.optics, pool_);
  Trial fine{error, gather(sources, error, {&before, nullptr})};
  while (fine.squared_error <= enough && fine.error < kCoarsest) {
    const Trial coarse{2.0f * fine.error, gather(sources, 2.0f * fine.error, {&before, nullptr})};
    if (coarse.squared_error > enough) return error_between(coarse, fine, enough);
    fine = coarse;
  }
  return fine.error;
}

GatherMeasure::Timed GatherMeasure::plan_within(const GatherSources& sources, double seconds) {
  using Clock = std::chrono::steady_clock;
  GatherPlan last;
  double last_seconds = 0.0;
  Scatter before, scatter;
  for (int trial = 0; trial < kTrials; ++trial) {
    const float error = std::ldexp(kCoarsest, -trial);
    const Clock::time_point start = Clock::now();
    const float squared_error = gather(sources, error, {&before, &scatter});
    const double taken = std::chrono::duration<double>(Clock::now() - start).count() / of_frame_;
    before = smoothed(scatter, sources.optics, pool_);
    const GatherPlan found{error, error, 0.0f, squared_error};
    if (taken > seconds) {
      if (trial == 0) return {found, true};
      // Between the last two, on a straight line in logarithms.
      const double t = taken > last_seconds ? std::log(seconds / last_seconds) / std::log(taken / last_seconds) : 0.0;
      const auto part = static_cast<float>(std::clamp(t, 0.0, 1.0));
      const float between = last.error * std::exp2(-part);
      return {{between, between, 0.0f, last.squared_error * std::pow(found.squared_error / last.squared_error, part)}, true};
    }
    if (found.squared_error <= kInvisible || (trial > kLeastTrials && found.squared_error > kStalled * last.squared_error))
      return {found, false};
    last = found, last_seconds = taken;
  }
  return {last, false};
}

}  // namespace lippmann
