#pragma once

#include <string>

#include "lippmann/formats/plenoptic_calibration.hpp"

namespace lippmann {

/// Estimates the grid from `white` (1 channel). The lens spacing must be between 4 pixels and a sixth of the picture. The grid
/// may have any rotation. The returned rotation is within 45 degrees for a square grid and within 15 degrees for a hexagonal
/// grid (kHexagonal or kHexagonalColumns). Throws Error naming `where` if there is no such grid.
LensGridFit estimate_lens_grid(const Image& white, const std::string& where);

/// Returns, for example, "lens grid: hexagonal, pitch 10.135 x 8.777 px, rotation 0.12 deg, a lens at (1640.2, 1639.8)
/// px; 125000 lenses, residual 0.03 px RMS".
std::string lens_grid_text(const LensGridFit& fit);

}  // namespace lippmann
