// The loop over camera packets. It combines objects of three kinds: packets generate rays, the integrator shades them, and
// sinks record other data.
//
//    Packets     bool fill(int packet, int sample, CameraPacket& into)   returns false if no lane is active
//    Integrator  void primary(CameraPacket& packet)   shades traced rays; may queue secondary rays
//                void finish()                        traces all queued rays
//                void begin(int sample)               optional: sets the sample number of the next rays
#pragma once

#include <algorithm>
#include <span>

#include "device/ray_scene.hpp"
#include "trace/frame_work.hpp"
#include "trace/packet_source.hpp"
#include "trace/point_capture.hpp"

namespace lippmann {

/// The packets and sample numbers to trace. For each sample number, all packets are shaded before their secondary rays are
/// traced.
struct Batch {
  std::span<const int> packets;
  int first_sample = 0, end_sample = 1, step = 1;
};

struct PacketSinks {
  Image* film = nullptr;  ///< set to 0 in each pixel before its first sample; may be null
  const PointCapture* points = nullptr;
};

struct NoIntegrator {
  void primary(const CameraPacket&) {}
  void finish() {}
};

inline void clear_pixels(const CameraPacket& packet, Image& film) {
  for (int i = 0; i < kLanes; ++i)
    if (packet.active.lane[i]) std::fill_n(film.data.begin() + 3 * static_cast<std::ptrdiff_t>(packet.target[i]), 3, 0.0f);
}

/// Deactivates lanes whose light the optics block. Returns whether any lane is still active.
inline bool leave_out_blocked(CameraPacket& packet) {
  int left = 0;
  for (int i = 0; i < kLanes; ++i) {
    if (packet.rays.ray.tfar[i] == kBlocked) packet.active.lane[i] = 0;
    left |= packet.active.lane[i];
  }
  return left != 0;
}

template <class Packets, class Integrator>
void trace_batch(const ShadedScene& scene, Packets&& packets, const Batch& batch, Integrator& integrator,
                 const PacketSinks& sinks = {}) {
  CameraPacket packet;
  for (int sample = batch.first_sample; sample < batch.end_sample; sample += batch.step) {
    if constexpr (requires { integrator.begin(sample); }) integrator.begin(sample);
    for (const int p : batch.packets) {
      if (!packets.fill(p, sample, packet)) continue;
      if (sinks.film && sample == batch.first_sample) clear_pixels(packet, *sinks.film);
      if (!leave_out_blocked(packet)) continue;
      std::copy_n(packet.rays.ray.tfar, kLanes, packet.reach.lane);
      scene.trace(packet.active, packet.rays, Coherence::kCoherent, &packet.active);
      if (sinks.points) sinks.points->store(packet);
      integrator.primary(packet);
    }
    integrator.finish();
  }
}

/// Traces one camera ray through the centre of each pixel of the shot's rows. Many threads use `integrator` at once.
template <class Integrator>
void trace_centres(const Shot& shot, RayOrder order, const ThreadPool& pool, Integrator& integrator,
                   const PacketSinks& sinks = {}) {
  const PacketSource source(shot.optics, shot.world_from_display, order, SubPixel{}, shot.rows);
  pool.for_each(static_cast<std::size_t>(source.strips()), [&](std::size_t strip) {
    for_each_batch({}, strip, source.packets_per_strip(), [&](std::span<const int> batch, std::size_t) {
      trace_batch(shot.device.shaded(), StripPackets{source, static_cast<int>(strip)}, {batch}, integrator, sinks);
    });
  });
}

}  // namespace lippmann
