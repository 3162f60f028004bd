// Pictures of which a display's crosstalk (optics/crosstalk.hpp) makes the wanted ones.
//
// An eye sees A v' where v' is shown, A the share of each neighbour: views are looked for of which it sees v. Light cannot be
// negative, nor brighter than the display, so that v' is found within 0 ... 1 that comes nearest; where it has to stop at these
// bounds, contrast is out of reach, and by how much is what comes back.
#pragma once

#include "lippmann/image/encoding.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/precompensation.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Larger sigmas leave so little of what tells neighbours apart (8 %) that there is nothing to gain.
inline constexpr double kMaxPrecompensatedPx = 0.75;

/// `picture`: what the panel is to show, 3 channels of linear light, above 1 as bright as the display is; a slanted panel's of
/// whole pixels. It becomes what makes an eye see that. 0 <= sigma_px <= kMaxPrecompensatedPx. Throws a usage Error naming
/// `where` for a larger one, and for optics without neighbours (a single view).
Precompensation precompensate(const Optics& optics, double sigma_px, const char* where, Image& picture);

/// The same of a film of any encoding: of display-referred values the light that they are shown as.
Precompensation precompensate_encoded(const Optics& optics, double sigma_px, Encoding encoding, const char* where, Image& film);

}  // namespace lippmann
