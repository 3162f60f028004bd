#pragma once

#include "device/lanes.hpp"

namespace lippmann {

/// The transmittance of a packet of shadow rays. For each lane, it is the product of `white` and `tint`. Most transparent
/// surfaces attenuate all channels equally, so that most packets need no tint.
struct Transmittance {
  Lanes white;             ///< factor on all colour channels; 1 for new rays
  Lanes3 tint;             ///< defined if is_tinted is true
  bool is_tinted = false;  ///< whether any lane has a tint

  Vec3f at(int i) const { return is_tinted ? white[i] * tint.get(i) : Vec3f(white[i]); }
};

}  // namespace lippmann
