#include "reuse/held_out.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace lippmann {
namespace {

constexpr double kNormal99 = 2.326;  // one-sided; why not that of 95 %: see the header

constexpr std::array<std::uint8_t, 256> kLevels = [] {
  std::array<std::uint8_t, 256> levels{};
  int level = 0;
  for (int doubt = 0; doubt < 256; ++doubt) {
    if (doubt > kLevelEnd[static_cast<std::size_t>(level)]) ++level;
    levels[static_cast<std::size_t>(doubt)] = static_cast<std::uint8_t>(level);
  }
  return levels;
}();

/// Where in its run the next sample of a level lies.
class Runs {
 public:
  Runs(std::uint32_t length, std::uint32_t seed, int frame)
      : length_(length), seed_(hash(seed, static_cast<std::uint32_t>(frame))) {
    for (std::uint32_t level = 0; level < kDoubtLevels; ++level) begin(level);
  }

  /// Whether the next pixel of a level is the sample of its run.
  bool draw(std::uint32_t level) {
    Run& run = runs_[level];
    const bool drawn = run.place == run.sample;
    if (++run.place == length_) ++run.index, run.place = 0, begin(level);
    return drawn;
  }

 private:
  struct Run {
    std::uint32_t index = 0, place = 0, sample = 0;
  };

  void begin(std::uint32_t level) { runs_[level].sample = hash(seed_, level, runs_[level].index) % length_; }

  std::uint32_t length_, seed_;
  std::array<Run, kDoubtLevels> runs_;
};

/// Sums over the samples of one level.
struct Sums {
  double count = 0.0, sum = 0.0, squares = 0.0, largest = 0.0;

  void add(double error) {
    count += 1.0, sum += error, squares += error * error;
    largest = std::max(largest, error);
  }
  double mean() const { return sum / count; }
  double squared_deviations() const { return std::max(0.0, squares - sum * mean()); }
};

}  // namespace

int level_of(std::uint8_t doubt) { return kLevels[doubt]; }

std::uint32_t patches_per_sample(std::size_t patches) {
  constexpr std::size_t kLeast = 4, kMost = 32, kSamples = 1500;
  return static_cast<std::uint32_t>(std::clamp(patches / kSamples, kLeast, kMost));
}

HeldOut hold_out(std::span<const std::uint8_t> doubt, std::uint32_t seed, int frame) {
  HeldOut held_out{};
  Runs runs(patches_per_sample(doubt.size()), seed, frame);
  for (std::size_t p = 0; p < doubt.size(); ++p) {
    const std::uint8_t level = kLevels[doubt[p]];
    ++held_out.population[level];
    if (!runs.draw(level)) continue;
    held_out.patches.push_back(static_cast<std::uint32_t>(p));
    held_out.levels.push_back(level);
  }
  return held_out;
}

std::array<ErrorEstimate, kDoubtLevels> estimate_errors(const HeldOut& held_out, std::span<const double> squared_errors) {
  std::array<Sums, kDoubtLevels> sums;
  for (std::size_t i = 0; i < squared_errors.size(); ++i) sums[held_out.levels[i]].add(squared_errors[i]);
  double patches = 0.0;
  for (const std::uint64_t population : held_out.population) patches += static_cast<double>(population);

  std::array<ErrorEstimate, kDoubtLevels> errors;
  double mse = 0.0, variance = 0.0, weight = 0.0, unseen = kUnseenError * kUnseenError;
  for (std::size_t h = 0; h < errors.size(); ++h) {
    const double population = static_cast<double>(held_out.population[h]);
    if (sums[h].count > 0.0) {
      const double of_sample = (population - sums[h].count) / (patches * sums[h].count);
      mse += of_sample * sums[h].sum;
      variance += of_sample * of_sample * sums[h].squared_deviations();
      weight = std::max(weight, of_sample);
      unseen = std::max(unseen, sums[h].largest);
    } else {
      mse += population / patches * kLevelEnd[h] * kLevelEnd[h];
    }
    const double not_drawn = weight * unseen;
    errors[h] = {mse, mse + not_drawn + kNormal99 * std::sqrt(variance + not_drawn * not_drawn)};
  }
  return errors;
}

int trusted_levels(const std::array<ErrorEstimate, kDoubtLevels>& errors, double mse) {
  const auto failed = std::find_if(errors.begin(), errors.end(), [&](const ErrorEstimate& e) { return e.bound > mse; });
  return static_cast<int>(failed - errors.begin());
}

}  // namespace lippmann
