// Numbers in [0, 1) for the decisions along a path: Owen-scrambled Sobol points, decorrelated between pixels, frames and the
// pairs of dimensions.
//
// Based on: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020. Every pair of dimensions is the same two-
// dimensional Sobol sequence, its order shuffled and its digits scrambled by hashes, so that any number of dimensions has
// well-spread pairs.
#pragma once

#include <cstdint>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Point `index` of a scrambled Sobol sequence of two dimensions; any 2^k points from a multiple of 2^k on are stratified.
Vec2f scrambled_sobol(std::uint32_t index, std::uint32_t seed);

/// The numbers of one path, drawn in a fixed order. A pixel's paths share the seed and differ in the index.
class PathSampler {
 public:
  PathSampler(std::uint32_t seed, std::uint32_t index);

  /// Two numbers, evenly spread over the pixel's paths; each call is a pair of dimensions of its own.
  Vec2f next();

  /// Goes on with pair `pair`, whatever was drawn before: so that a decision has the same numbers on all paths.
  void jump_to(std::uint32_t pair) { pair_ = pair; }

 private:
  std::uint32_t seed_, reversed_index_, pair_ = 0;
};

/// Paths side by side, whose numbers are drawn together in a fraction of the time.
struct PathPairs {
  static constexpr int kPaths = 16;
  alignas(64) std::uint32_t seed[kPaths], index[kPaths];  ///< as PathSampler's
  alignas(64) std::uint32_t first[kPaths];                ///< the pair that they begin with
};

/// What PathSampler(seed, index) gives after jump_to(first + pair), for each of the paths.
void sample_pairs(const PathPairs& paths, std::uint32_t pair, float* x, float* y);

}  // namespace lippmann
