// A packet of sixteen camera rays.
#pragma once

#include "device/ray_packet.hpp"

namespace lippmann {

struct CameraPacket {
  RayHitPacket rays;  ///< the caller sets origin, direction, tnear and tfar; tracing sets the hits
  LaneMask active;
  Lanes reach;  ///< tfar of each ray before tracing, which replaces tfar by the distance of the hit
  /// Index of the value to which each lane's light is added. This is normally the pixel y * width + x in the rendered rows.
  /// Callers that trace single samples may store the light elsewhere.
  alignas(64) std::uint32_t target[kLanes];
  /// Random numbers of a lane depend on its stream and its sample number. The stream is normally the index of the pixel in the
  /// whole film.
  alignas(64) std::uint32_t stream[kLanes], sample[kLanes];
};

/// Sets stream and sample of all lanes. Call set_streams() while `target` still holds pixel indices in the whole film.
inline void set_streams(int sample, CameraPacket& packet) {
  LIPPMANN_FOR_LANES(i) packet.stream[i] = packet.target[i], packet.sample[i] = static_cast<std::uint32_t>(sample);
}

}  // namespace lippmann
