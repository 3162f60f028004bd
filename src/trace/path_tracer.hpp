// Light along random paths from the lens array into the scene, wave by wave: next-event estimation at every surface, and a
// direction drawn from its BSDF. Private to src/trace.
//
// Based on: J. Kajiya, "The rendering equation", SIGGRAPH 1986; E. Veach, "Robust Monte Carlo Methods for Light Transport
// Simulation", 1997 (multiple importance sampling, the power heuristic; Russian roulette).
#pragma once

#include <array>
#include <vector>

#include "core/random.hpp"
#include "trace/path_wave.hpp"
#include "trace/shadow_queue.hpp"
#include "trace/trace_frame.hpp"
#include "transport/sampler.hpp"

namespace lippmann {

/// What decides the random numbers of a frame's paths, and what becomes of them.
struct PathParams {
  int max_depth = 6;            ///< path vertices on surfaces
  std::uint32_t seed = 0;       ///< of the frame: other frames have other noise
  float clamp_indirect = 0.0f;  ///< > 0: no indirect contribution of a path is brighter than this; loses light
};
/// Of the frame that `trace` describes.
inline PathParams path_params(const TraceParams& trace) {
  return {trace.max_depth, hash(trace.seed, trace.frame), trace.clamp_indirect};
}

/// What the camera rays' first surfaces are, weighted as their light: see NoisyFrame.
struct FirstSurfaces {
  float *albedo, *normal;                   ///< three channels
  float *z, *met;                           ///< one
  Vec4f display_z{0.0f, 0.0f, 0.0f, 0.0f};  ///< z in display mm = dot with (x, y, z, 1)

  void add(const ShadingPoint& point, Vec3f normal_there, std::size_t pixel, float weight) const;
};
/// The last row of the matrix from world to display.
Vec4f display_z(const Affine3f& world_from_display);

/// Where light goes: three channels a pixel each; null: nowhere.
struct PathFilm {
  float* all = nullptr;
  float* direct = nullptr;    ///< what shines by itself, and what one surface has scattered
  float* indirect = nullptr;  ///< the rest
  float* noise = nullptr;     ///< see begin_sample()
  float* seen = nullptr;      ///< what has met no surface, or shines from the first
  const FirstSurfaces* surfaces = nullptr;
  float* open = nullptr;  ///< one channel: how many samples would see the surroundings, which they then do not
};

/// Tracing state of one thread at a time. Adds radiance to pixels of `film`; const inputs must outlive it.
class PathTracer {
 public:
  /// `scene` was made for Integrator::kPath; film.all is not null.
  PathTracer(const DeviceScene::Impl& scene, const BeamFootprint& beam, const PathParams& params, const PathFilm& film);

  /// From now on paths are sample number `sample` of their pixels; in film.noise their light counts noise_weight as much.
  void begin_sample(int sample, float noise_weight = 0.0f) {
    sample_ = static_cast<std::uint32_t>(sample);
    noise_weight_ = noise_weight;
  }

  /// Traces and shades a packet of primary rays (origin, direction, tnear, tfar set); adds weight x radiance to each active
  /// lane's pixel. What goes on from there waits for finish_batch().
  void primary(RayHitPacket& packet, const LaneMask& active, const std::uint32_t* pixel, float weight);

  /// Random numbers of a vertex.
  struct Numbers {
    float pick;  ///< which light
    Vec2f on_light, way;
  };

  /// Begins to gather what a diffuse surface receives but for lights of groups before `from` (not kPoint): of other lights by
  /// aiming at one, of all else by a path. Adds throughput x what a white surface there would send on to ray.pixel of the film.
  /// `ray` led to the point, `length` from its start.
  /// before: takes the surface back to where it was in the frame before; null: it lies still, or nobody watches.
  void gather_diffuse(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray, float length, LightGroup from,
                      const Numbers& numbers, const Affine3f* before = nullptr);

  /// What has to do with what moves, by pixel of the film: see LightRecord.
  struct Doubt {
    float light = 0.0f, share = 0.0f;
    /// The same of a surface that moves by itself: by how much more light falls onto it as it stands now than as it stood, were
    /// the way free.
    float turned_light = 0.0f, turned_share = 0.0f;
  };
  /// From now on every ray that gather_diffuse() leads to is tested against the probe's boxes; `doubts`, one for each pixel of
  /// the film, receives what those that meet one stand for. Both outlive this.
  void watch(const TouchProbe& probe, std::vector<Doubt>& doubts) { probe_ = &probe, doubts_ = &doubts; }

  /// Traces everything that waits, wave by wave.
  void finish_batch();

  const RayCounts& counts() const { return counts_; }

 private:
  void shade(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays);
  void watch_wave(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays);
  void draw_numbers(const PathRay* rays);
  void look_at_sky(const RayPacket& rays);
  void shade_sky(const RayHitPacket& packet, int lane, const PathRay& ray);
  void shade_surface(const RayHitPacket& packet, int lane, const PathRay& ray);
  void add_emission(const RayHitPacket& packet, int lane, const PathRay& ray, Vec3f emission);
  void aim_at_light(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray, float pick, Vec2f u);
  void scatter(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray, float length, float lobe, float survival,
               Vec2f u);
  void trace_shadow_rays();
  void watch_turning(Vec3f position, Vec3f normal, const LightSample& light, const Affine3f& before, const PathRay& ray);
  Vec3f clamped(Vec3f radiance, int depth) const;
  void end_path(const PathRay& ray, Vec3f light, float share);
  void add(std::uint32_t pixel, Vec3f radiance, int depth);

  const DeviceScene::Impl& scene_;
  const BeamFootprint& beam_;
  PathParams params_;
  PathFilm film_;
  const TouchProbe* probe_ = nullptr;  ///< null: nothing is watched
  std::vector<Doubt>* doubts_ = nullptr;
  std::uint32_t sample_ = 0;
  float weight_ = 1.0f;  ///< of one sample
  float noise_weight_ = 0.0f;
  RayCounts counts_;
  std::vector<PathRay> wave_, next_;
  ShadowQueue shadow_rays_;
  SurfacePacket surface_;
  SkyRays sky_;  ///< of the packet's lanes
  struct LanePairs {
    Lanes x, y;
  };
  std::array<LanePairs, kPairsPerEvent> numbers_;  ///< of the surfaces' lanes
};

}  // namespace lippmann
