// Held-out patches are a sample of an in-between frame's patches. They are traced to estimate the error of the other, predicted
// patches.
//
// Patches (patches.hpp) are sorted into levels by their uncertainty (uncertainty.hpp), and each level is sampled separately:
// one patch of each run of R consecutive patches of a level, at a position hashed from seed, frame, level and run. Each patch
// thus has the probability 1/R, and samples are spread evenly over levels and image (stratified sampling of clusters: W. G.
// Cochran, "Sampling Techniques", 3rd ed., 1977, chapters 5 and 9).
//
// Let N be the number of patches in the frame, N_h those of level h, n_h of them drawn, e_hi the mean squared errors of the
// known samples of that level (over pixels and R, G, B, in 8-bit display codes), k_h their number and m_h their mean. The mean
// squared error that levels 0 ... H leave in the frame, with all other patches and the samples themselves traced, is estimated
// by
//   M = sum_h w_h sum_i e_hi,   w_h = (N_h - n_h) / (N k_h),
// and bounded from above, at 95 % confidence, by
//   U = M + w e + 2.326 sqrt(sum_h w_h^2 sum_i (e_hi - m_h)^2 + (w e)^2),   w the largest w_h.
// The second term stands for one sample that was not drawn: errors are rare and heavy-tailed, and an error absent from n
// samples may still occur once in n + 1. Its error e is the largest one drawn, but at least kUnseenError. If k samples have
// equal errors and the others none, U sets k to 3.3, 5.3, 7.0, 8.7 for k = 0, 1, 2, 3. The exact 95 % limits of a Poisson count
// are 3.0, 4.7, 6.3, 7.8: rare errors are not normally distributed, so the normal quantile of 95 %, 1.645, would be too low,
// and that of 99 % is used. The bound covers errors that samples can find; an error of a hundred codes in a few pixels of a
// frame and nowhere else must stay below kUnseenError. A level without known samples is assumed to have its uncertainty as
// error.
//
// The known samples are the frame's own and, with weight kLearnedWeight, all patches of a nearby frame that was both predicted
// and completely traced: the error of a level of uncertainty is assumed to be the same in both. Thus few samples of the frame
// itself are needed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lippmann {

/// Levels of uncertainty: 0, 1, 2, 3, then with a width of about the square root of 2.
inline constexpr int kUncertaintyLevels = 24;
/// The largest uncertainty that belongs to each level.
inline constexpr std::array<std::uint8_t, kUncertaintyLevels> kLevelEnd{0,  1,  2,  3,  4,  5,  6,  8,  10, 12,  14,  17,
                                                                        20, 24, 28, 34, 40, 48, 57, 68, 81, 114, 161, 255};

int level_of(std::uint8_t uncertainty);

/// Lowest assumed error of a sample that was not drawn: the root mean square over a patch, in codes. An error in only one pixel
/// of 16 counts a quarter.
inline constexpr double kUnseenError = 12.0;

/// The sample of one frame.
struct HeldOut {
  std::vector<std::uint32_t> patches;                        ///< ascending
  std::vector<std::uint8_t> levels;                          ///< level of each entry of `patches`
  std::array<std::uint64_t, kUncertaintyLevels> population;  ///< number of the frame's patches by level
  std::array<std::uint64_t, kUncertaintyLevels> drawn;       ///< number of sampled patches by level
};

/// Returns the run length R for a number of patches per frame. It gives about 400 samples, but R stays within 4 ... 64.
std::uint32_t patches_per_sample(std::size_t patches);

/// Draws the sample of a frame. `uncertainty` has one entry per patch.
HeldOut hold_out(std::span<const std::uint8_t> uncertainty, std::uint32_t seed, int frame);

/// Weight of a patch of the learning frame, in samples: its errors are correlated with those of its neighbours, and other
/// frames differ from it.
inline constexpr double kLearnedWeight = 0.5;

/// The errors of the known samples.
struct Evidence {
  /// Count of one level's samples, and sums over their mean squared errors, in codes.
  struct Level {
    double count = 0.0, sum = 0.0, squares = 0.0, largest = 0.0;
  };
  std::array<Level, kUncertaintyLevels> levels;

  /// Adds samples. `squared_errors` has one entry per held-out patch.
  void add(const HeldOut& held_out, std::span<const double> squared_errors);
  void add(const Evidence& other);
  /// Scales the weight of all samples.
  void weigh(double weight);
};

/// Mean squared errors of a frame, in squared codes.
struct ErrorEstimate {
  double mse = 0.0;    ///< M, the estimate
  double bound = 0.0;  ///< U, the upper bound
};

/// Returns estimates whose entry h is the error that levels 0 ... h leave in the frame of `held_out`. `evidence` contains the
/// errors of that sample, and optionally others.
std::array<ErrorEstimate, kUncertaintyLevels> estimate_errors(const HeldOut& held_out, const Evidence& evidence);

/// Returns the number of lowest levels that can be trusted to keep the frame's error at or below `mse`. The bounds of all these
/// levels are at or below `mse`. Levels are tested in a fixed order until one fails, so the probability of trusting too many is
/// 5 %, regardless of the number of tests.
int trusted_levels(const std::array<ErrorEstimate, kUncertaintyLevels>& errors, double mse);

}  // namespace lippmann
