// Precompensates pictures for a display's crosstalk (optics/crosstalk.hpp). If the display shows v', an eye sees A v', where
// the matrix A holds the crosstalk weights. precompensate() computes v' such that A v' is the intended picture v, or as close
// to v as possible with light from 0 (black) to 1 (white). struct Precompensation measures the loss of contrast.
#pragma once

#include "lippmann/image/encoding.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/precompensation.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Largest standard deviation of a lens's blur, in pixels, that can be precompensated. A stronger blur leaves less than 8 % of
/// the difference between neighbouring pixels.
inline constexpr double kMaxPrecompensatedPx = 0.75;

/// Replaces a picture by one that makes an eye see the original. `picture`: the panel's picture, 3 channels of linear light,
/// clamped to 1, with one pixel per panel pixel also for a slanted panel. `sigma_px`: the standard deviation of a lens's blur,
/// from 0 to kMaxPrecompensatedPx. Throws a usage Error naming `where` for a larger sigma, and for optics in which pixels have
/// no neighbours (a single view).
Precompensation precompensate(const Optics& optics, double sigma_px, const char* where, Image& picture);

/// Precompensates a film of any encoding. Display-referred values are converted to linear light and back.
Precompensation precompensate_encoded(const Optics& optics, double sigma_px, Encoding encoding, const char* where, Image& film);

}  // namespace lippmann
