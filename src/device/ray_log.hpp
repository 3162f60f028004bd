// Keeps packets that a Whitted frame traces, so that a benchmark can trace the very same rays with nothing around them.
#pragma once

#include <vector>

#include "device/ray_packet.hpp"

namespace lippmann {

struct LoggedPacket {
  RayPacket rays;  ///< as handed to Embree: after planes have shortened them
  LaneMask active;
  bool shadow = false;
  Coherence coherence = Coherence::kIncoherent;
};

using RayLog = std::vector<LoggedPacket>;

/// Rays whose nearest hits are asked for.
inline LoggedPacket logged(const RayPacket& rays, const LaneMask& active, Coherence coherence) {
  LoggedPacket packet{rays, active, false, coherence};
  make_ready(packet.rays);
  return packet;
}

}  // namespace lippmann
