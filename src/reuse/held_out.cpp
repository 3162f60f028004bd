#include "reuse/held_out.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace lippmann {
namespace {

// one-sided 99 % normal quantile, see the header
constexpr double kNormal99 = 2.326;

constexpr std::array<std::uint8_t, 256> kLevels = [] {
  std::array<std::uint8_t, 256> levels{};
  int level = 0;
  for (int uncertainty = 0; uncertainty < 256; ++uncertainty) {
    if (uncertainty > kLevelEnd[static_cast<std::size_t>(level)]) ++level;
    levels[static_cast<std::size_t>(uncertainty)] = static_cast<std::uint8_t>(level);
  }
  return levels;
}();

class Runs {
 public:
  Runs(std::uint32_t length, std::uint32_t seed, int frame)
      : length_(length), seed_(hash(seed, static_cast<std::uint32_t>(frame))) {
    for (std::uint32_t level = 0; level < kUncertaintyLevels; ++level) begin(level);
  }

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
  std::array<Run, kUncertaintyLevels> runs_;
};

double squared_deviations(const Evidence::Level& level) {
  return std::max(0.0, level.squares - level.sum * level.sum / level.count);
}

}  // namespace

int level_of(std::uint8_t uncertainty) { return kLevels[uncertainty]; }

std::uint32_t patches_per_sample(std::size_t patches) {
  constexpr std::size_t kLeast = 4, kMost = 64, kSamples = 400;
  return static_cast<std::uint32_t>(std::clamp(patches / kSamples, kLeast, kMost));
}

HeldOut hold_out(std::span<const std::uint8_t> uncertainty, std::uint32_t seed, int frame) {
  HeldOut held_out{};
  Runs runs(patches_per_sample(uncertainty.size()), seed, frame);
  for (std::size_t p = 0; p < uncertainty.size(); ++p) {
    const std::uint8_t level = kLevels[uncertainty[p]];
    ++held_out.population[level];
    if (!runs.draw(level)) continue;
    ++held_out.drawn[level];
    held_out.patches.push_back(static_cast<std::uint32_t>(p));
    held_out.levels.push_back(level);
  }
  return held_out;
}

void Evidence::add(const HeldOut& held_out, std::span<const double> squared_errors) {
  for (std::size_t i = 0; i < squared_errors.size(); ++i) {
    Level& level = levels[held_out.levels[i]];
    const double error = squared_errors[i];
    level.count += 1.0, level.sum += error, level.squares += error * error;
    level.largest = std::max(level.largest, error);
  }
}

void Evidence::add(const Evidence& other) {
  for (std::size_t h = 0; h < levels.size(); ++h) {
    levels[h].count += other.levels[h].count, levels[h].sum += other.levels[h].sum;
    levels[h].squares += other.levels[h].squares;
    levels[h].largest = std::max(levels[h].largest, other.levels[h].largest);
  }
}

void Evidence::weigh(double weight) {
  for (Level& level : levels) level.count *= weight, level.sum *= weight, level.squares *= weight;
}

std::array<ErrorEstimate, kUncertaintyLevels> estimate_errors(const HeldOut& held_out, const Evidence& evidence) {
  double patches = 0.0;
  for (const std::uint64_t population : held_out.population) patches += static_cast<double>(population);

  std::array<ErrorEstimate, kUncertaintyLevels> errors;
  double mse = 0.0, variance = 0.0, weight = 0.0, unseen = kUnseenError * kUnseenError;
  for (std::size_t h = 0; h < errors.size(); ++h) {
    const Evidence::Level& known = evidence.levels[h];
    const double untraced = static_cast<double>(held_out.population[h] - held_out.drawn[h]);
    if (known.count > 0.0) {
      const double of_sample = untraced / (patches * known.count);
      mse += of_sample * known.sum;
      variance += of_sample * of_sample * squared_deviations(known);
      weight = std::max(weight, of_sample);
      unseen = std::max(unseen, known.largest);
    } else {
      mse += untraced / patches * kLevelEnd[h] * kLevelEnd[h];
    }
    const double not_drawn = weight * unseen;
    errors[h] = {mse, mse + not_drawn + kNormal99 * std::sqrt(variance + not_drawn * not_drawn)};
  }
  return errors;
}

int trusted_levels(const std::array<ErrorEstimate, kUncertaintyLevels>& errors, double mse) {
  const auto failed = std::find_if(errors.begin(), errors.end(), [&](const ErrorEstimate& e) { return e.bound > mse; });
  return static_cast<int>(failed - errors.begin());
}

}  // namespace lippmann
