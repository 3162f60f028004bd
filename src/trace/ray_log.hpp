// Keeps every packet that a Whitted frame traces, so that a benchmark can trace the very same rays with nothing around them.
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

}  // namespace lippmann
