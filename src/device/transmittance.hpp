// Transmittance of a packet of shadow rays.
#pragma once

#include "device/lanes.hpp"

namespace lippmann {

/// The transmittance of a lane is the product of `white` and `tint`. Most see-through surfaces attenuate all channels equally,
/// so most packets never use the tint.
struct Transmittance {
  Lanes white;             ///< 1 for new rays
  Lanes3 tint;             ///< valid if is_tinted is set
  bool is_tinted = false;  ///< whether any lane has a tint

  Vec3f at(int i) const { return is_tinted ? white[i] * tint.get(i) : Vec3f(white[i]); }
};

}  // namespace lippmann
