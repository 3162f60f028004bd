// The splats along sixteen rays, nearest first.
//
// A ray's list ends where the transmittance falls below kDark. Splats behind that point are dropped, and the search can stop
// there. The final list does not depend on the order in which splats are found: a splat is only dropped if the splats before it
// are opaque enough, and more splats before it only lower the transmittance.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "device/lanes.hpp"

namespace lippmann {

/// A transmittance below this value counts as 0.
inline constexpr float kDark = 1.0f / 1024.0f;

struct SplatHit {
  float t;              ///< distance of the splat's maximum along the ray
  float alpha;          ///< opacity at distance t
  float left;           ///< transmittance of this splat and all before it
  std::uint32_t splat;  ///< index in SplatTable::splats
};

/// Holds the lists of a packet's lanes. Reuses its memory from packet to packet.
class SplatHits {
 public:
  void clear() {
    for (std::vector<SplatHit>& hits : of_lane_) hits.clear();
  }

  const std::vector<SplatHit>& of(int lane) const { return of_lane_[static_cast<std::size_t>(lane)]; }

  /// Adds a splat to a lane's list, unless the splats before it are opaque. Returns the distance up to which further splats
  /// count, at most `reach`.
  float add(std::size_t lane, SplatHit hit, float reach);

 private:
  std::array<std::vector<SplatHit>, kLanes> of_lane_;
};

}  // namespace lippmann
