// Tachyon's fractal landscape (SCAPE): computes heights on a grid by midpoint displacement. The heights are identical to
// Tachyon's.
//
// After: A. Fournier, D. Fussell, L. Carpenter, "Computer rendering of stochastic models", CACM 25(6), 1982, with Tachyon's
// displacement, clamping, order of subdivision and random numbers: x <- 1099087573 x mod 2^32, the multiplier of G. S.
// Fishman, "Multiplicative congruential random number generators with modulus 2^beta", Math. Comp. 54, 1990.
#pragma once

#include <vector>

namespace lippmann::tachyon {

struct LandscapeSize {
  int columns = 2, rows = 2;        ///< grid points along x and z, each >= 2
  double width = 1.0, depth = 1.0;  ///< sizes along x and z
};

/// Returns heights[row * columns + column], each >= 0. Takes about (larger side)^2 steps.
std::vector<double> landscape_heights(const LandscapeSize& size);

}  // namespace lippmann::tachyon
