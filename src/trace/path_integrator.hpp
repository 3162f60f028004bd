// Path tracing, wave by wave: at every vertex one light is sampled by a shadow ray (next-event estimation), and the path goes
// on in a direction drawn from the BSDF, until roulette or its depth ends it.
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
#include "trace/path_film.hpp"
#include "trace/path_numbers.hpp"
#include "trace/path_wave.hpp"
#include "trace/shadow_queue.hpp"

namespace lippmann {

struct PathParams {
  int max_depth = 6;            ///< path vertices on surfaces
  std::uint32_t seed = 0;       ///< one for each frame: other frames have other noise
  float clamp_indirect = 0.0f;  ///< > 0: no indirect contribution of a path is brighter than this; loses light
  int spp = 1;                  ///< samples per pixel: each counts 1 / spp
};

/// Used by one thread at a time. The class is large because all of its state belongs to the packet that is being shaded:
/// path_lights.cpp has the light that rays meet, path_integrator.cpp all else.
class PathIntegrator {
 public:
  /// The scene was made for Integrator::kPath; film.all is not null. All arguments must outlive this object.
  PathIntegrator(const ShadedScene& scene, const BeamFootprint& beam, const PathParams& params, const PathFilm& film);

  /// From now on camera rays are sample number `sample` of their pixels.
  void begin(int sample);
  /// Shades camera rays that have met the scene. The rest of their paths waits for finish().
  void primary(const CameraPacket& packet);
  /// Traces everything that waits, wave by wave.
  void finish();

  const RayCounts& counts() const { return counts_; }

 private:
  /// Where the paths of a packet have met surfaces that scatter.
  struct Vertices {
    LaneMask active;
    std::array<ShadingPoint, kLanes> points;
    Lanes lengths;       ///< from the start of each path
    Lanes near_share{};  ///< LightReceiver::near_share, where the scene has both kinds of lights
    BsdfPacket bsdfs;

    const ShadingPoint& point(int i) const { return points[static_cast<std::size_t>(i)]; }
    /// Asks for lights.
    LightReceiver receiver(int i) const { return {point(i).position, bsdfs.lit_side(i, point(i).normal)}; }
  };

  const LightTable& lights() const { return *scene_.path->lights; }

  // Of all functions below, `rays` are by lane.
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

  /// Adds light that a ray has met.
  void end_path(const PathRay& ray, Vec3f radiance) { add(ray.pixel, clamped(radiance, ray.surfaces()), ray.surfaces()); }
  Vec3f clamped(Vec3f radiance, int depth) const;
  void add(std::uint32_t pixel, Vec3f radiance, int depth);

  const ShadedScene& scene_;
  const BeamFootprint& beam_;
  PathParams params_;
  PathFilm film_;
  float weight_;                          ///< of a sample's light
  std::array<float, 2> noise_weights_{};  ///< of a sample of the first and of the second half: see weights_of_halves()
  float noise_weight_ = 0.0f;             ///< that of this sample
  RayCounts counts_;
  std::vector<PathRay> wave_, next_;  ///< rays of this wave and of the next
  SurfacePacket surface_;             ///< surfaces of the packet that is being shaded
  Vertices vertices_;                 ///< those of them that scatter
  PathNumbers numbers_;
  SkyRays sky_;  ///< by lane of the packet
  SplatHits splat_hits_;
  ShadowQueue shadow_rays_;
};

}  // namespace lippmann
