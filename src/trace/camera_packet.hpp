// A packet of sixteen camera rays.
#pragma once

#include "device/ray_packet.hpp"

namespace lippmann {

struct CameraPacket {
  RayHitPacket rays;  ///< the caller sets origin, direction, tnear and tfar; tracing adds the hits
  LaneMask active;
  Lanes reach;  ///< tfar before tracing
  /// Target of each lane's light: a pixel (y * width + x within the rendered rows), or a slot defined by the caller that
  /// traces single samples.
  alignas(64) std::uint32_t target[kLanes];
  /// Each lane draws the random numbers of sample `sample` of stream `stream`. A stream is normally a pixel of the whole film.
  alignas(64) std::uint32_t stream[kLanes], sample[kLanes];
};

/// Seeds each lane by its target pixel and sample number. Call this before targets are rebased to the rendered rows.
inline void set_streams(int sample, CameraPacket& packet) {
  LIPPMANN_FOR_LANES(i) packet.stream[i] = packet.target[i], packet.sample[i] = static_cast<std::uint32_t>(sample);
}

}  // namespace lippmann
