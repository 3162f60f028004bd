#pragma once

#include "device/lanes.hpp"

namespace lippmann {

/// The transmittance of shadow rays: the product of `white` and `tint`. Most transparent surfaces attenuate all channels
/// equally and need no tint.
struct Transmittance {
  Lanes white;  ///< factor on all colour channels; 1 for new rays
  Lanes3 tint;
  bool is_tinted = false;

  Vec3f at(int i) const { return is_tinted ? white[i] * tint.get(i) : Vec3f(white[i]); }
};

}  // namespace lippmann
