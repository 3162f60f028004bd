// Precompensates pictures for a display's crosstalk (optics/crosstalk.hpp).
//
// If the display shows v', an eye sees A v', where A holds the crosstalk weights. We look for v' such that the eye sees the
// intended v. Light cannot be negative or exceed the display's white, so we find the closest solution within 0 ... 1. Where it
// reaches these bounds, contrast is lost, and the result reports how much.
#pragma once

#include "lippmann/image/encoding.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/precompensation.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Largest supported sigma. Beyond it, too little of the difference between neighbours remains (8 %) to be restored.
inline constexpr double kMaxPrecompensatedPx = 0.75;

/// Replaces a picture by one that makes an eye see the original. `picture`: the panel's picture, 3 channels of linear light,
/// clamped to 1, the display's white; for a slanted panel, of whole pixels. 0 <= sigma_px <= kMaxPrecompensatedPx. Throws a
/// usage Error naming `where` for a larger sigma, and for optics without neighbours (a single view).
Precompensation precompensate(const Optics& optics, double sigma_px, const char* where, Image& picture);

/// Does the same for a film of any encoding; display-referred values are converted to light and back.
Precompensation precompensate_encoded(const Optics& optics, double sigma_px, Encoding encoding, const char* where, Image& film);

}  // namespace lippmann
