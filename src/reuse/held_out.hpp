// Estimates the error of an in-between frame from a random sample of its patches.
//
// A patch (patches.hpp) of an in-between frame is predicted, which means made from other frames. The sampled patches are called
// held-out: they are traced as well, and the difference gives the error of the prediction.
//
// Patches are sorted into levels by their uncertainty (uncertainty.hpp). Each level is sampled separately. The patches of a
// level are divided into runs of R consecutive patches. One patch of each run is drawn, at a position hashed from seed, frame,
// level and run. Each patch thus has the probability 1/R, and the samples are spread evenly over levels and image (stratified
// sampling of clusters: W. G. Cochran, "Sampling Techniques", 3rd ed., 1977, chapters 5 and 9).
//
// Let N be the number of patches in the frame, N_h the number of patches of level h, and n_h the number of patches drawn from
// level h. Level h has k_h samples with known errors. The mean squared error of sample i is e_hi (over pixels and R, G, B, in
// squared 8-bit display codes), and the mean of the e_hi is m_h. Suppose that levels 0 ... H remain predicted, and that all
// other patches and all drawn patches are traced. The mean squared error of the frame is then estimated by
//   M = sum_h w_h sum_i e_hi,   w_h = (N_h - n_h) / (N k_h),
// and bounded from above, at 95 % confidence, by
//   U = M + w e + 2.326 sqrt(sum_h w_h^2 sum_i (e_hi - m_h)^2 + (w e)^2),   where w is the largest w_h.
//
// The term w e stands for one error that was not drawn. Errors are rare and heavy-tailed: an error absent from n samples may
// still occur once in n + 1. Its size e is the largest error drawn, but at least kUnseenError^2. The bound does not cover a
// larger error that no sample finds, such as a hundred codes in a few pixels of one frame.
//
// The factor 2.326 is the 99 % normal quantile. The 95 % quantile, 1.645, would be too low, because rare errors are not
// normally distributed. Suppose that k of many samples have the error e and all other samples have none. U then corresponds to
// k + 1 + 2.326 sqrt(k + 1) errors: 3.3, 5.3, 7.0, 8.7 for k = 0, 1, 2, 3. The exact 95 % limits of a Poisson count are 3.0,
// 4.7, 6.3, 7.8.
//
// Known samples come from two frames: the drawn patches of the frame itself, and, with weight kLearnedWeight, all patches of a
// nearby frame that was both predicted and completely traced. The error at a level is assumed to be the same in both frames, so
// the frame itself needs few samples. A level without known samples is assumed to have an error equal to its uncertainty.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lippmann {

inline constexpr int kUncertaintyLevels = 24;
/// Largest uncertainty of each level.
inline constexpr std::array<std::uint8_t, kUncertaintyLevels> kLevelEnd{0,  1,  2,  3,  4,  5,  6,  8,  10, 12,  14,  17,
                                                                        20, 24, 28, 34, 40, 48, 57, 68, 81, 114, 161, 255};

int level_of(std::uint8_t uncertainty);

/// Lowest assumed error of a patch that was not drawn: root mean square over its 16 pixels, in 8-bit codes.
inline constexpr double kUnseenError = 12.0;

struct HeldOut {
  std::vector<std::uint32_t> patches;
  std::vector<std::uint8_t> levels;
  std::array<std::uint64_t, kUncertaintyLevels> population;
  std::array<std::uint64_t, kUncertaintyLevels> drawn;
};

/// Returns R, the length of the runs from which hold_out() draws one patch each. R is chosen so that about 400 patches are
/// drawn, but is at least 4 and at most 64.
std::uint32_t patches_per_sample(std::size_t patches);

HeldOut hold_out(std::span<const std::uint8_t> uncertainty, std::uint32_t seed, int frame);

/// Weight of a patch of another frame, relative to a patch of the frame itself. Below 1, because errors of neighbouring patches
/// are correlated and frames differ.
inline constexpr double kLearnedWeight = 0.5;

struct Evidence {
  /// Count, sum, sum of squares and maximum of the mean squared errors of a level's samples, in squared codes.
  struct Level {
    double count = 0.0, sum = 0.0, squares = 0.0, largest = 0.0;
  };
  std::array<Level, kUncertaintyLevels> levels;

  void add(const HeldOut& held_out, std::span<const double> squared_errors);
  void add(const Evidence& other);
  void weigh(double weight);
};

struct ErrorEstimate {
  double mse = 0.0;    ///< the estimate M at the top of this file
  double bound = 0.0;  ///< the upper bound U at the top of this file
};

/// Returns one estimate per level. Entry h applies to a frame in which only levels 0 ... h remain predicted.
std::array<ErrorEstimate, kUncertaintyLevels> estimate_errors(const HeldOut& held_out, const Evidence& evidence);

/// Returns how many of the lowest levels may remain predicted if the frame's mean squared error must stay within `mse`. Testing
/// stops at the first level that fails, so the probability of accepting too many is 5 %.
int trusted_levels(const std::array<ErrorEstimate, kUncertaintyLevels>& errors, double mse);

}  // namespace lippmann
