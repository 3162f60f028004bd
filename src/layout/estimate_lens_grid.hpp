// Finds the lens grid of a plenoptic camera in a picture of flat white light.
#pragma once

#include <string>

#include "lippmann/layout/lens_grid.hpp"

namespace lippmann {

struct LensGridFit {
  LensGrid grid;             ///< its offset is the lens nearest to the middle of the picture
  int lenses = 0;            ///< whose centres were fitted
  double residual_px = 0.0;  ///< root mean square distance from a centre to the grid's
};

/// `white`: 1 channel. Lenses are at least 4 pixels and at most a sixteenth of the picture apart, and turned by any angle
/// (square: up to 45 degrees; hexagonal: 15, from rows or columns). Throws Error naming `where` if there is no such grid.
LensGridFit estimate_lens_grid(const Image& white, const std::string& where);

/// "hexagonal, pitch 10.135 x 8.777 px, rotation 0.12 deg, a lens at (1640.2, 1639.8) px; 125000 lenses, residual 0.03 px RMS"
std::string described(const LensGridFit& fit);

}  // namespace lippmann
