// Path tracing in waves of rays. Each vertex samples one light by a shadow ray, and the next direction from the BSDF. Russian
// roulette or the maximum depth ends a path.
//
// Based on: J. Kajiya, "The rendering equation", SIGGRAPH 1986; E. Veach, "Robust Monte Carlo Methods for Light Transport
// Simulation", 1997 (multiple importance sampling, the power heuristic; Russian roulette).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lippmann/trace/ray_counts.hpp"
#include "shading/bsdf_packet.hpp"
#include "shading/light_table.hpp"
#include "shading/splat_light.hpp"
#include "trace/integrator_model.hpp"
#include "trace/path_film.hpp"
#include "trace/path_numbers.hpp"
#include "trace/path_wave.hpp"
#include "trace/shadow_queue.hpp"

namespace lippmann {

struct PathParams {
  int max_depth = 6;
  std::uint32_t seed = 0;       ///< different in each frame, so that the noise of frames is independent
  float clamp_indirect = 0.0f;  ///< each path's indirect light is clamped to this value, which darkens images; 0: not clamped
  int spp = 1;
};

/// Traces the paths of one thread. path_lights.cpp defines the functions for lights that rays hit, and path_integrator.cpp all
/// other functions.
class PathIntegrator final : public FrameIntegrator {
 public:
  /// `scene` must be built for Integrator::kPath. film.all must not be null. The arguments must outlive this object.
  PathIntegrator(const ShadedScene& scene, const BeamFootprint& beam, const PathParams& params, const PathFilm& film);

  void begin(int sample) override;
  void primary(const CameraPacket& packet) override;
  void finish() override;

  const RayCounts& counts() const override { return counts_; }

 private:
  struct Vertices {
    LaneMask active;
    std::array<ShadingPoint, kLanes> points;
    Lanes lengths;
    Lanes near_share{};  ///< see LightReceiver::near_share; set only if the scene has both near and far lights
    BsdfPacket bsdfs;

    const ShadingPoint& point(int i) const { return points[static_cast<std::size_t>(i)]; }
    LightReceiver receiver(int i) const { return {point(i).position, bsdfs.lit_side(i, point(i).normal)}; }
  };

  const LightTable& lights() const { return *scene_.path->lights; }

  // `rays` has one element per lane.
  void shade(const RayHitPacket& packet, LaneMask active, PathRay* rays);
  void draw_numbers(const PathRay* rays);
  void shade_surface(const RayHitPacket& packet, int i, PathRay& ray);
  void pass_wall(const RayHitPacket& packet, int i, const PathRay& ray, float length);
  void make_one_color(PathRay& ray, int i);
  void scatter(const RayHitPacket& packet, const PathRay* rays);
  void sample_lights(const PathRay* rays);
  std::optional<LightSample> light_for(int i);
  void shine(int i, const LightSample& light, const BsdfValue& value, const PathRay& ray);
  Vec3f from_wide_light(int i, const LightSample& light, const BsdfValue& value) const;
  void follow(int i, const PathRay& ray, const BsdfSample& sample);
  PathRay* send_on(const PathRay& ray, const ShadingPoint& point, const BsdfSample& sample, Vec3f throughput, float length);
  void trace_shadow_rays();

  void meet_splats(const RayPacket& packet, LaneMask& active, PathRay* rays);
  void meet_round_lights(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays);
  void meet_round_light(std::size_t k, const PathRay& ray, float reach);
  void look_up_sky(const RayPacket& rays);
  void shade_miss(const RayHitPacket& packet, int i, const PathRay& ray);
  void meet_emission(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f emission);

  void end_path(const PathRay& ray, Vec3f radiance) { add(ray.pixel, clamped(radiance, ray.surfaces()), ray.surfaces()); }
  Vec3f clamped(Vec3f radiance, int depth) const;
  void add(std::uint32_t pixel, Vec3f radiance, int depth);

  const ShadedScene& scene_;
  const BeamFootprint& beam_;
  PathParams params_;
  PathFilm film_;
  float weight_;
  std::array<float, 2> noise_weights_{};
  float noise_weight_ = 0.0f;
  RayCounts counts_;
  std::vector<PathRay> wave_, next_;
  SurfacePacket surface_;
  Vertices vertices_;
  PathNumbers numbers_;
  SkyRays sky_;
  SplatHits splat_hits_;
  ShadowQueue shadow_rays_;
};

}  // namespace lippmann
