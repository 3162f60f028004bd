// Random numbers in [0, 1) for the decisions of paths: Owen-scrambled Sobol points. The points of different pixels, frames and
// pairs of dimensions are independent.
//
// Based on: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020. Each pair of dimensions is the same
// two-dimensional Sobol sequence, shuffled and scrambled by hashes.
#pragma once

#include <cstdint>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns point `index` of a scrambled two-dimensional Sobol sequence. Each aligned block of 2^k points is stratified.
Vec2f scrambled_sobol(std::uint32_t index, std::uint32_t seed);

/// Paths whose random numbers are computed together. Paths of the same pixel have the same seed and different indices.
struct PathPairs {
  static constexpr int kPaths = 16;
  alignas(64) std::uint32_t seed[kPaths], index[kPaths];
  alignas(64) std::uint32_t first[kPaths];  ///< number of the path's first pair of dimensions; sample_pairs() adds `pair`
};

/// Computes two random numbers per path, stratified over the paths of a pixel. The sum first + pair selects a pair of
/// dimensions. Pairs for different sums are independent, so a decision must use the same sum on all paths.
void sample_pairs(const PathPairs& paths, std::uint32_t pair, float* x, float* y);

}  // namespace lippmann
