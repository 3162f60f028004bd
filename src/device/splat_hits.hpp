// The splats that sixteen rays meet, nearest first.
//
// A ray's list ends where less than kDark of what lies behind shines through: splats behind that point are not kept, and
// whoever looks for more of them need not look there. What is in a list in the end depends on the splats alone, not on the
// order in which they were found: a splat is left out only if those before it are dark already, and more of them before it
// make it no lighter.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "device/lanes.hpp"

namespace lippmann {

/// Where less of the light shines through splats, nothing does.
inline constexpr float kDark = 1.0f / 1024.0f;

struct SplatHit {
  float t;              ///< where the ray comes nearest to the splat, in standard deviations
  float alpha;          ///< how much it covers there
  float left;           ///< the share of light that passes it and all before it
  std::uint32_t splat;  ///< in SplatTable::splats
};

/// Memory is kept from packet to packet.
class SplatHits {
 public:
  void clear() {
    for (std::vector<SplatHit>& hits : of_lane_) hits.clear();
  }

  const std::vector<SplatHit>& of(int lane) const { return of_lane_[static_cast<std::size_t>(lane)]; }

  /// Adds a splat to a lane's list, unless those before it are dark. Returns up to where others count, at most `reach`.
  float add(std::size_t lane, SplatHit hit, float reach);

 private:
  std::array<std::vector<SplatHit>, kLanes> of_lane_;
};

}  // namespace lippmann
