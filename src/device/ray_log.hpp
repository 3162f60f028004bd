// Records the packets of a Whitted frame, so that a benchmark can trace the same rays in isolation.
#pragma once

#include <vector>

#include "device/ray_packet.hpp"

namespace lippmann {

struct LoggedPacket {
  RayPacket rays;  ///< the rays as passed to Embree, after planes have shortened them
  LaneMask active;
  bool shadow = false;
  Coherence coherence = Coherence::kIncoherent;
};

using RayLog = std::vector<LoggedPacket>;

/// Returns a record of rays that are traced to their nearest hits.
inline LoggedPacket logged(const RayPacket& rays, const LaneMask& active, Coherence coherence) {
  LoggedPacket packet{rays, active, false, coherence};
  make_ready(packet.rays);
  return packet;
}

}  // namespace lippmann
