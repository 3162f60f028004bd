// Path tracing in waves of rays. At every vertex, a shadow ray samples one light (next-event estimation), and the path
// continues in a direction sampled from the BSDF. Russian roulette or the maximum depth ends the path.
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
  int max_depth = 6;            ///< maximum number of path vertices on surfaces
  std::uint32_t seed = 0;       ///< differs between frames, so that their noise is independent
  float clamp_indirect = 0.0f;  ///< > 0: upper limit of a path's indirect contribution, which loses light; 0: no limit
  int spp = 1;                  ///< samples per pixel; each has the weight 1 / spp
};

/// Traces the paths of one thread; not thread-safe. The class is large because all of its functions share the state of the
/// packet that is being shaded. path_lights.cpp handles lights that rays hit, path_integrator.cpp everything else.
class PathIntegrator final : public FrameIntegrator {
 public:
  /// `scene` must be built for Integrator::kPath, and film.all must not be null. The arguments must outlive this object.
  PathIntegrator(const ShadedScene& scene, const BeamFootprint& beam, const PathParams& params, const PathFilm& film);

  void begin(int sample) override;
  /// Shades the first hits of camera rays. finish() traces the rest of their paths.
  void primary(const CameraPacket& packet) override;
  /// Traces all remaining rays, wave by wave.
  void finish() override;

  const RayCounts& counts() const override { return counts_; }

 private:
  /// The vertices of a packet's paths on surfaces that scatter light.
  struct Vertices {
    LaneMask active;
    std::array<ShadingPoint, kLanes> points;
    Lanes lengths;       ///< path length up to the vertex
    Lanes near_share{};  ///< LightReceiver::near_share, set if the scene has both near and far lights
    BsdfPacket bsdfs;

    const ShadingPoint& point(int i) const { return points[static_cast<std::size_t>(i)]; }
    /// The input of light sampling.
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

  /// Adds light that a ray has hit.
  void end_path(const PathRay& ray, Vec3f radiance) { add(ray.pixel, clamped(radiance, ray.surfaces()), ray.surfaces()); }
  Vec3f clamped(Vec3f radiance, int depth) const;
  void add(std::uint32_t pixel, Vec3f radiance, int depth);

  const ShadedScene& scene_;
  const BeamFootprint& beam_;
  PathParams params_;
  PathFilm film_;
  float weight_;                          ///< weight of a sample
  std::array<float, 2> noise_weights_{};  ///< weights of samples in the first and the second half: see weights_of_halves()
  float noise_weight_ = 0.0f;             ///< noise weight of the current sample
  RayCounts counts_;
  std::vector<PathRay> wave_, next_;  ///< rays of this wave and of the next
  SurfacePacket surface_;             ///< surfaces hit by the packet that is being shaded
  Vertices vertices_;                 ///< vertices on those surfaces of surface_ that scatter light
  PathNumbers numbers_;
  SkyRays sky_;  ///< one ray per lane of the packet
  SplatHits splat_hits_;
  ShadowQueue shadow_rays_;
};

}  // namespace lippmann
