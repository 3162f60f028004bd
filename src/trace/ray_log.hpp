// Keeps packets that a Whitted frame traces, so that a benchmark can trace the very same rays with nothing around them.
#pragma once

#include <vector>

#include "trace/embree_shim.hpp"

namespace lippmann {

struct LoggedPacket {
  RayPacket rays;  ///< as handed to Embree: after planes have shortened them
  LaneMask active;
  bool shadow = false;
  Coherence coherence = Coherence::kIncoherent;
};

using RayLog = std::vector<LoggedPacket>;

/// Rays whose nearest hits are asked for, with the words that Embree wants besides.
inline LoggedPacket logged(const RayPacket& rays, const LaneMask& active, Coherence coherence) {
  LoggedPacket packet{rays, active, false, coherence};
  for (int i = 0; i < kLanes; ++i) {
    packet.rays.time[i] = 0.0f;
    packet.rays.mask[i] = ~0u;
    packet.rays.id[i] = static_cast<unsigned>(i);
    packet.rays.flags[i] = 0;
  }
  return packet;
}

}  // namespace lippmann
