// Sixteen camera rays that are traced together.
#pragma once

#include "device/ray_packet.hpp"

namespace lippmann {

struct CameraPacket {
  RayHitPacket rays;  ///< origin, direction, tnear and tfar are set; once traced, also what was hit
  LaneMask active;
  Lanes reach;  ///< tfar before they were traced
  /// Where a lane's light goes: its pixel (y * width + x of the rows that are rendered), or a slot of whoever traces samples
  /// one by one.
  alignas(64) std::uint32_t target[kLanes];
  /// Random numbers are those of sample number `sample` of a stream. A stream is a pixel of the whole film, as a rule.
  alignas(64) std::uint32_t stream[kLanes], sample[kLanes];
};

/// Random numbers are those of a sample of the pixel that the light goes to. Before targets are counted from later rows.
inline void set_streams(int sample, CameraPacket& packet) {
  LIPPMANN_FOR_LANES(i) packet.stream[i] = packet.target[i], packet.sample[i] = static_cast<std::uint32_t>(sample);
}

}  // namespace lippmann
