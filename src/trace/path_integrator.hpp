// Path tracing in waves of rays. At every vertex, a shadow ray samples one light (next-event estimation). The path then
// continues in a direction sampled from the BSDF, until Russian roulette or the maximum depth ends it.
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
  int max_depth = 6;            ///< maximum number of vertices of a path
  std::uint32_t seed = 0;       ///< different in each frame, so that the noise of frames is independent
  float clamp_indirect = 0.0f;  ///< > 0: upper limit of one path's indirect light (images get darker); 0: no limit
  int spp = 1;                  ///< samples per pixel; each sample has the weight 1 / spp
};

/// Traces the paths of one thread. Not thread-safe. The class is large because all its functions share the state of the packet
/// that is being shaded. path_lights.cpp defines the functions for lights that rays hit, and path_integrator.cpp all others.
class PathIntegrator final : public FrameIntegrator {
 public:
  /// `scene` must be built for Integrator::kPath. film.all must not be null. The arguments must outlive this object.
  PathIntegrator(const ShadedScene& scene, const BeamFootprint& beam, const PathParams& params, const PathFilm& film);

  void begin(int sample) override;
  /// Shades the hits of camera rays. finish() traces the rest of their paths.
  void primary(const CameraPacket& packet) override;
  void finish() override;

  const RayCounts& counts() const override { return counts_; }

 private:
  /// The path vertices of a packet, on surfaces that scatter light.
  struct Vertices {
    LaneMask active;
    std::array<ShadingPoint, kLanes> points;
    Lanes lengths;       ///< length of each path up to its vertex
    Lanes near_share{};  ///< LightReceiver::near_share; defined if the scene has both near and far lights
    BsdfPacket bsdfs;

    const ShadingPoint& point(int i) const { return points[static_cast<std::size_t>(i)]; }
    /// Returns the receiver from which lights are sampled.
    LightReceiver receiver(int i) const { return {point(i).position, bsdfs.lit_side(i, point(i).normal)}; }
  };

  const LightTable& lights() const { return *scene_.path->lights; }

  // In all functions below, `rays` has one element per lane.
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

  /// Adds light that the ray has hit.
  void end_path(const PathRay& ray, Vec3f radiance) { add(ray.pixel, clamped(radiance, ray.surfaces()), ray.surfaces()); }
  Vec3f clamped(Vec3f radiance, int depth) const;
  void add(std::uint32_t pixel, Vec3f radiance, int depth);

  const ShadedScene& scene_;
  const BeamFootprint& beam_;
  PathParams params_;
  PathFilm film_;
  float weight_;                          ///< weight of a sample in the film
  std::array<float, 2> noise_weights_{};  ///< result of weights_of_halves() (NoisyFrame)
  float noise_weight_ = 0.0f;             ///< element of noise_weights_ for the current sample
  RayCounts counts_;
  std::vector<PathRay> wave_, next_;  ///< rays of the current and of the next wave
  SurfacePacket surface_;             ///< surfaces that the current packet has hit
  Vertices vertices_;                 ///< the current packet's vertices
  PathNumbers numbers_;
  SkyRays sky_;  ///< the sky in the direction of each lane's ray
  SplatHits splat_hits_;
  ShadowQueue shadow_rays_;
};

}  // namespace lippmann
