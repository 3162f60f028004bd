#pragma once

#include "device/ray_packet.hpp"

namespace lippmann {

struct CameraPacket {
  RayHitPacket rays;
  LaneMask active;
  Lanes reach;
  /// Pixel (y * width + x in the rendered rows) to which each lane's light is added.
  alignas(64) std::uint32_t target[kLanes];
  /// The random numbers of a lane depend on its stream (normally the pixel's index in the whole film) and its sample number.
  alignas(64) std::uint32_t stream[kLanes], sample[kLanes];
};

/// Sets the streams to the pixels in `target`, which must still be indices in the whole film.
inline void set_streams(int sample, CameraPacket& packet) {
  LIPPMANN_FOR_LANES(i) packet.stream[i] = packet.target[i], packet.sample[i] = static_cast<std::uint32_t>(sample);
}

}  // namespace lippmann
