// Pictures of which a display's crosstalk (optics/crosstalk.hpp) makes the wanted ones.
//
// An eye sees A v' where v' is shown, A the share of each neighbour: views are looked for of which it sees v. Light cannot be
// negative, nor brighter than the display, so that v' is found within 0 ... 1 that comes nearest; where it has to stop at these
// bounds, contrast is out of reach, and by how much is what comes back.
#pragma once

#include "image/image.hpp"
#include "optics/optics.hpp"

namespace lippmann {

/// Larger sigmas leave so little of what tells neighbours apart (8 %) that there is nothing to gain.
inline constexpr double kMaxPrecompensatedPx = 0.75;

struct Precompensation {
  double clipped_share = 0.0;     ///< of samples: that would have to be darker than black or brighter than white
  double largest_residual = 0.0;  ///< how far what is seen is from what was wanted, at worst; linear light, 1 is white

  bool operator==(const Precompensation&) const = default;
};

/// `picture`: what the panel is to show, 3 channels of linear light, above 1 as bright as the display is; a slanted panel's of
/// whole pixels. It becomes what makes an eye see that. 0 <= sigma_px <= kMaxPrecompensatedPx. Throws a usage Error naming
/// `where` for a larger one, and for optics without neighbours (a single view).
Precompensation precompensate(const Optics& optics, double sigma_px, const char* where, Image& picture);

}  // namespace lippmann
