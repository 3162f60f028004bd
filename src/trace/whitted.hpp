// Whitted's recursive ray tracing, in waves: a batch of packets is shaded, its mirror and refracted rays are queued, the queue
// is the next wave.
//
// Based on: T. Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980.
// We deviate: (1) breadth first instead of recursion, so that secondary rays travel in full packets of neighbours; (2) at the
// depth limit a mirror shows the background instead of black, as Tachyon does.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "device/ray_log.hpp"
#include "lippmann/image/image.hpp"
#include "shading/direct_light.hpp"
#include "shading/splat_light.hpp"
#include "shading/surface.hpp"
#include "trace/camera_packet.hpp"
#include "trace/integrator_model.hpp"
#include "trace/path_film.hpp"
#include "trace/ray_queue.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {

struct WhittedParams {
  int max_depth = 6;  ///< 1 = no mirrors
  int spp = 1;        ///< samples of a pixel: each counts 1 / spp
};

/// Tracing state of one thread at a time. Adds radiance to pixels of the film; const inputs must outlive it.
class WhittedTracer final : public FrameIntegrator {
 public:
  /// film.all is not null. Where film.open is not null, it receives how many samples would see the surroundings, which they
  /// then do not see.
  WhittedTracer(const ShadedScene& scene, const BeamFootprint& beam, const WhittedParams& params, const PathFilm& film);

  /// Shades camera rays that have met the scene. Mirror and refracted rays wait for finish().
  void primary(const CameraPacket& packet) override;

  /// Traces everything that waits, wave by wave.
  void finish() override;

  const RayCounts& counts() const override { return counts_; }

  void begin(int) override {}

  /// From now on appends every packet to `log` that follows from camera packets.
  void log_to(RayLog* log) { log_ = log; }

  void tell(BlockProbe* probe) override { probe_ = probe; }

 private:
  void shade(const RayHitPacket& packet, LaneMask active, Bundle& bundle, int depth);
  void look_at_splats(const RayPacket& rays, LaneMask& active, Bundle& bundle);
  void gather_light(const RayHitPacket& packet, DirectLight& direct);
  void gather_lights(const RayHitPacket& packet, std::span<const WhittedLight> lights, DirectLight& direct);
  void branch(const RayHitPacket& packet, const Bundle& bundle, bool last, Lanes3& radiance);
  void see_surroundings(const RayHitPacket& packet, const LaneMask& active, const Bundle& bundle, Lanes3& radiance);
  void refract(const RayHitPacket& packet, Branches& branches) const;
  void add_to_film(const LaneMask& active, const Bundle& bundle, const Lanes3& radiance);

  const ShadedScene& scene_;
  const BeamFootprint& beam_;
  int max_depth_;
  float weight_;  ///< what a sample counts
  PathFilm film_;
  RayCounts counts_;
  RayLog* log_ = nullptr;
  BlockProbe* probe_ = nullptr;
  RayQueue wave_, next_;
  SurfacePacket surface_;
  SplatHits splat_hits_;
  std::vector<ShadowPacket> shadows_;  ///< one for each light of those that are sampled at once
  std::vector<int> shadow_rays_;       ///< active lanes of each
};

}  // namespace lippmann
