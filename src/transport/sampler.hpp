// Random numbers in [0, 1) for path decisions: Owen-scrambled Sobol points, decorrelated between pixels, frames and pairs of
// dimensions.
//
// Based on: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020. Each pair of dimensions is the same
// two-dimensional Sobol sequence, with its order shuffled and its digits scrambled by hashes. Any number of dimensions thus has
// well-distributed pairs.
#pragma once

#include <cstdint>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns point `index` of a scrambled two-dimensional Sobol sequence. Each aligned block of 2^k points is stratified.
Vec2f scrambled_sobol(std::uint32_t index, std::uint32_t seed);

/// A group of paths whose numbers are drawn together. The paths of a pixel share the seed and differ in the index.
struct PathPairs {
  static constexpr int kPaths = 16;
  alignas(64) std::uint32_t seed[kPaths], index[kPaths];
  alignas(64) std::uint32_t first[kPaths];  ///< index of each path's first pair
};

/// Draws two numbers per path, well distributed over the paths of a pixel. Each value of first + pair is an independent pair of
/// dimensions. Thus use the same value for the same decision on all paths.
void sample_pairs(const PathPairs& paths, std::uint32_t pair, float* x, float* y);

}  // namespace lippmann
