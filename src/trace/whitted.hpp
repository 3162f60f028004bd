// Whitted's recursive ray tracing, in waves: a batch of packets is shaded, its mirror and refracted rays are queued, the queue
// is the next wave. Private to src/trace.
//
// Based on: T. Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980.
// We deviate: (1) breadth first instead of recursion, so that secondary rays travel in full packets of neighbours; (2) at the
// depth limit a mirror shows the background instead of black, as Tachyon does.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/image/image.hpp"
#include "trace/direct_light.hpp"
#include "trace/point_capture.hpp"
#include "trace/ray_log.hpp"
#include "trace/ray_queue.hpp"
#include "trace/surface.hpp"
#include "trace/touch_probe.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {

/// Tracing state of one thread at a time. Adds radiance to pixels of `film`; const inputs must outlive it.
class WhittedTracer {
 public:
  WhittedTracer(const DeviceScene::Impl& scene, const BeamFootprint& beam, int max_depth, Image& film);

  /// Traces and shades a packet of primary rays (origin, direction, tnear, tfar set); adds weight x radiance to each active
  /// lane's pixel (index y * width + x). Mirror and refracted rays wait for finish_batch().
  void primary(RayHitPacket& packet, const LaneMask& active, const std::uint32_t* pixel, float weight);

  /// Traces everything that waits, wave by wave.
  void finish_batch();

  const RayCounts& counts() const { return counts_; }

  /// From now on camera rays do not see the surroundings, but what of them would is added to `open`, by pixel, in samples.
  void leave_open(float* open) { open_ = open; }

  /// From now on appends every traced packet to `log`.
  void log_to(RayLog* log) { log_ = log; }

  /// From now on keeps the first hits of primary packets.
  void capture_to(const PointCapture* capture) { capture_ = capture; }

  /// From now on tells `probe` of every ray.
  void tell(BlockProbe* probe) { probe_ = probe; }

 private:
  void shade(const RayHitPacket& packet, const LaneMask& active, const Bundle& bundle, int depth);
  void gather_light(const RayHitPacket& packet, DirectLight& direct);
  void branch(const RayHitPacket& packet, const Bundle& bundle, bool last, Lanes3& radiance);
  void see_surroundings(const RayHitPacket& packet, const LaneMask& active, const Bundle& bundle, Lanes3& radiance);
  void refract(const RayHitPacket& packet, Branches& branches) const;
  void add_to_film(const LaneMask& active, const Bundle& bundle, const Lanes3& radiance);

  const DeviceScene::Impl& scene_;
  const BeamFootprint& beam_;
  int max_depth_;
  float* film_;
  float* open_ = nullptr;
  RayCounts counts_;
  RayLog* log_ = nullptr;
  const PointCapture* capture_ = nullptr;
  BlockProbe* probe_ = nullptr;
  RayQueue wave_, next_;
  SurfacePacket surface_;
  std::vector<ShadowPacket> shadows_;  ///< per light
  std::vector<int> shadow_rays_;       ///< active lanes of each
};

}  // namespace lippmann
