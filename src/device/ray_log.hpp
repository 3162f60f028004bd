#pragma once

#include <vector>

#include "device/ray_packet.hpp"

namespace lippmann {

struct LoggedPacket {
  RayPacket rays;
  LaneMask active;
  bool shadow = false;
  Coherence coherence = Coherence::kIncoherent;
};

using RayLog = std::vector<LoggedPacket>;

inline LoggedPacket logged(const RayPacket& rays, const LaneMask& active, Coherence coherence) {
  LoggedPacket packet{rays, active, false, coherence};
  make_ready(packet.rays);
  return packet;
}

}  // namespace lippmann
