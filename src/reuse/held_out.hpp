// Held-out patches: a sample of an in-between frame's predictions that is traced to learn how wrong the others are.
//
// Patches (patches.hpp) are sorted into levels by their uncertainty (uncertainty.hpp), and every level is sampled by itself: of
// each run of R consecutive patches of a level one, at a place hashed from seed, frame, level and run. So every patch has the
// chance 1/R, and samples are spread evenly over levels and picture (stratified sampling of clusters: W. G. Cochran, "Sampling
// Techniques", 3rd ed., 1977, chapters 5 and 9).
//
// With N patches in the frame, N_h in level h, n_h of them drawn, e_hi the mean squared errors of the samples known of that
// level (over pixels and R, G, B, in 8-bit display codes), k_h how many and m_h their mean, the mean squared error that levels
// 0 ... H leave in the frame, everything else and the samples themselves being traced, is estimated by
//   M = sum_h w_h sum_i e_hi,   w_h = (N_h - n_h) / (N k_h),
// and bounded from above, at 95 % confidence, by
//   U = M + w e + 2.326 sqrt(sum_h w_h^2 sum_i (e_hi - m_h)^2 + (w e)^2),   w the largest w_h.
// The second term is a sample that was not drawn: errors are few and heavy-tailed, and what is not among n samples may still
// happen once in n + 1. It errs as much as the worst that was drawn, and by no less than kUnseenError. If k of the samples err
// by the same amount and the others not at all, U puts k at 3.3, 5.3, 7.0, 8.7 for k = 0, 1, 2, 3, where the exact 95 % limits
// of a Poisson count are 3.0, 4.7, 6.3, 7.8: few errors are not normally distributed, so that the normal quantile of 95
// %, 1.645, would fall short of them, and that of 99 % is taken. It is a bound for errors like those that samples can find:
// what is wrong in a few pixels of a frame, by a hundred codes, and nowhere else, has to stay below kUnseenError. A level of
// which no sample is known is taken to err by its uncertainty.
//
// The samples known are the frame's own and, by kLearnedWeight, all patches of a frame near by that was predicted and traced as
// a whole: what a level of uncertainty errs by is taken to be the same in both. Then few of the frame's own are needed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lippmann {

/// Levels of uncertainty: 0, 1, 2, 3, then about the square root of 2 wide.
inline constexpr int kUncertaintyLevels = 24;
/// The largest uncertainty of each level.
inline constexpr std::array<std::uint8_t, kUncertaintyLevels> kLevelEnd{0,  1,  2,  3,  4,  5,  6,  8,  10, 12,  14,  17,
                                                                        20, 24, 28, 34, 40, 48, 57, 68, 81, 114, 161, 255};

int level_of(std::uint8_t uncertainty);

inline constexpr double kUnseenError = 12.0;  ///< root mean square over a patch, codes: one pixel's error counts a quarter

/// The sample of one frame.
struct HeldOut {
  std::vector<std::uint32_t> patches;                        ///< ascending
  std::vector<std::uint8_t> levels;                          ///< by entry of `patches`: its level
  std::array<std::uint64_t, kUncertaintyLevels> population;  ///< patches of the frame by level
  std::array<std::uint64_t, kUncertaintyLevels> drawn;       ///< how many of them are in the sample
};

/// R for frames of that many patches: such that there are about 400 samples, within 4 ... 64.
std::uint32_t patches_per_sample(std::size_t patches);

/// uncertainty: by patch.
HeldOut hold_out(std::span<const std::uint8_t> uncertainty, std::uint32_t seed, int frame);

/// What a patch of the frame that was learned from counts as, in samples: its patches have their errors in common, with their
/// neighbours', and other frames will differ from it.
inline constexpr double kLearnedWeight = 0.5;

/// What samples have shown.
struct Evidence {
  /// Sums over the samples of one level; of their mean squared errors, in codes.
  struct Level {
    double count = 0.0, sum = 0.0, squares = 0.0, largest = 0.0;
  };
  std::array<Level, kUncertaintyLevels> levels;

  /// `squared_errors`: one per held-out patch.
  void add(const HeldOut& held_out, std::span<const double> squared_errors);
  void add(const Evidence& other);
  /// As if each sample had been drawn `weight` times.
  void weigh(double weight);
};

/// Mean squared errors in codes.
struct ErrorEstimate {
  double mse = 0.0;    ///< M
  double bound = 0.0;  ///< U
};

/// Entry h: what levels 0 ... h leave in the frame that `held_out` is of. `evidence`: of that sample, and maybe others.
std::array<ErrorEstimate, kUncertaintyLevels> estimate_errors(const HeldOut& held_out, const Evidence& evidence);

/// How many levels, from the lowest on, can be trusted so that the frame's error stays at or below `mse`: every one of their
/// bounds does. Levels are thus tested in a fixed order until one fails, so that trusting too many has a chance of 5 %, however
/// many are tested.
int trusted_levels(const std::array<ErrorEstimate, kUncertaintyLevels>& errors, double mse);

}  // namespace lippmann
