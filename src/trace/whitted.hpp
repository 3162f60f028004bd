// Whitted's recursive ray tracing in waves: mirrored and refracted rays of many packets form the next wave.
//
// Based on: T. Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980.
//
// We deviate:
// 1. Rays are traced breadth first, so that neighbouring secondary rays form full packets.
// 2. A mirror at the depth limit shows the background instead of black. Tachyon does the same.
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
  int max_depth = 6;
  int spp = 1;
};

/// Traces rays for one thread, and adds radiance to the film. The constructor's arguments must outlive this object.
class WhittedTracer final : public FrameIntegrator {
 public:
  /// film.all must not be null. If film.open is not null, it receives the number of samples that hit no surface, and these
  /// samples add no background to the film.
  WhittedTracer(const ShadedScene& scene, const BeamFootprint& beam, const WhittedParams& params, const PathFilm& film);

  void primary(const CameraPacket& packet) override;

  void finish() override;

  const RayCounts& counts() const override { return counts_; }

  void begin(int) override {}

  void log_to(RayLog* log) { log_ = log; }

  void set_probe(BlockProbe* probe) override { probe_ = probe; }

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
  float weight_;
  PathFilm film_;
  RayCounts counts_;
  RayLog* log_ = nullptr;
  BlockProbe* probe_ = nullptr;
  RayQueue wave_, next_;
  SurfacePacket surface_;
  SplatHits splat_hits_;
  std::vector<ShadowPacket> shadows_;
  std::vector<int> shadow_rays_;
};

}  // namespace lippmann
