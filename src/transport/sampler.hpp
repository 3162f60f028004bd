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

/// Paths side by side, whose numbers are drawn together. A pixel's paths share the seed and differ in the index.
struct PathPairs {
  static constexpr int kPaths = 16;
  alignas(64) std::uint32_t seed[kPaths], index[kPaths];
  alignas(64) std::uint32_t first[kPaths];  ///< the pair that they begin with
};

/// Two numbers for each path, evenly spread over its pixel's paths. Each value of first + pair is a pair of dimensions of its
/// own; so a decision that always takes the same one has the same numbers on all paths.
void sample_pairs(const PathPairs& paths, std::uint32_t pair, float* x, float* y);

}  // namespace lippmann
