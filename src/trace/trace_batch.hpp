// The loop over camera packets: every picture, layer and record is made by it. Packets say which rays there are, an integrator
// what becomes of them, sinks what is kept besides.
//
//   Packets     bool fill(int packet, int sample, CameraPacket& into)   false: no lane is active
//   Integrator  void primary(CameraPacket& packet)   shades rays that have met the scene; what goes on from there may wait
//               void finish()                        traces everything that waits
//               void begin(int sample)               where it has one: which sample of their pixels comes next
#pragma once

#include <algorithm>
#include <span>

#include "device/ray_scene.hpp"
#include "trace/frame_work.hpp"
#include "trace/point_capture.hpp"

namespace lippmann {

/// Packets whose rays are all shaded before what follows from them is traced, sample by sample.
struct Batch {
  std::span<const int> packets;
  int first_sample = 0, end_sample = 1, step = 1;
};

struct PacketSinks {
  Image* film = nullptr;                 ///< pixels become 0 before their first sample
  const PointCapture* points = nullptr;  ///< keeps what camera rays hit
};

/// An integrator that makes nothing: for sinks alone.
struct NoIntegrator {
  void primary(const CameraPacket&) {}
  void finish() {}
};

inline void clear_pixels(const CameraPacket& packet, Image& film) {
  for (int i = 0; i < kLanes; ++i)
    if (packet.active.lane[i]) std::fill_n(film.data.begin() + 3 * static_cast<std::ptrdiff_t>(packet.target[i]), 3, 0.0f);
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
      std::copy_n(packet.rays.ray.tfar, kLanes, packet.reach.lane);
      scene.trace(packet.active, packet.rays, Coherence::kCoherent, &packet.active);
      if (sinks.points) sinks.points->store(packet);
      integrator.primary(packet);
    }
    integrator.finish();
  }
}

/// One camera ray through the centre of every pixel of the shot's rows. `integrator` is used by many threads at a time.
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
