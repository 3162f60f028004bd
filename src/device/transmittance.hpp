// What is left of the light along a packet of shadow rays.
#pragma once

#include "device/lanes.hpp"

namespace lippmann {

/// White and tint together: most surfaces that let light pass weaken all colours alike, and packets that meet no others never
/// touch the tint.
struct Transmittance {
  Lanes white;             ///< 1 for fresh lanes
  Lanes3 tint;             ///< where is_tinted
  bool is_tinted = false;  ///< whether any lane is

  Vec3f at(int i) const { return is_tinted ? white[i] * tint.get(i) : Vec3f(white[i]); }
};

}  // namespace lippmann
