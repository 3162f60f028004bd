// The splats along sixteen rays, nearest first.
//
// The list of a ray ends where the transmittance falls below kDark. The order in which splats are found does not affect the
// list.
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
  float t;
  float alpha;  ///< opacity of the splat at distance t
  float left;   ///< transmittance of this splat and all splats in front of it
  std::uint32_t splat;
};

/// The memory is reused from packet to packet.
class SplatHits {
 public:
  void clear() {
    for (std::vector<SplatHit>& hits : of_lane_) hits.clear();
  }

  const std::vector<SplatHit>& of(int lane) const { return of_lane_[static_cast<std::size_t>(lane)]; }

  /// Adds a splat to a lane's list, unless the splats in front of it are opaque. Returns the distance up to which further
  /// splats may be visible, at most `reach`.
  float add(std::size_t lane, SplatHit hit, float reach);

 private:
  std::array<std::vector<SplatHit>, kLanes> of_lane_;
};

}  // namespace lippmann
