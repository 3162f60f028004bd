// Computes the heights of Tachyon's fractal landscape (SCAPE) on a grid by midpoint displacement. The heights are identical to
// Tachyon's.
//
// After: A. Fournier, D. Fussell, L. Carpenter, "Computer rendering of stochastic models", CACM 25(6), 1982. Displacement,
// clamping, order of subdivision and random numbers are Tachyon's. The random numbers are x <- 1099087573 x mod 2^32, with the
// multiplier of G. S. Fishman, "Multiplicative congruential random number generators with modulus 2^beta", Math. Comp. 54,
// 1990.
#pragma once

#include <vector>

namespace lippmann::tachyon {

struct LandscapeSize {
  int columns = 2, rows = 2;
  double width = 1.0, depth = 1.0;
};

/// Returns the heights of all grid points in row-major order: heights[row * columns + column]. All heights are >= 0. The number
/// of steps is about the square of the larger of columns and rows.
std::vector<double> landscape_heights(const LandscapeSize& size);

}  // namespace lippmann::tachyon
