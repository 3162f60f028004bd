// Paths that end in the light cache: from the lens array to surfaces, mirrors and glass exactly, lights that the cache does not
// hold by shadow rays, all other light on diffuse surfaces from the cache. Private to src/trace.
#pragma once

#include <array>

#include "trace/light_feeder.hpp"
#include "trace/phong_lanes.hpp"

namespace lippmann {

/// So many point-like lights are all asked at every point, and make no noise; of more of them, one.
inline constexpr std::size_t kFewLights = 4;

/// State of one thread at a time.
class LightGatherer {
 public:
  /// Adds radiance to pixels of `film`. All arguments outlive it.
  LightGatherer(const DeviceScene::Impl& scene, const LightCells& cells, const LightCache& cache, const PathParams& params,
                Image& film);

  /// From now on pictures show where light came from, in proportion to it: red what this frame traced, green what the cache was
  /// fed in this frame, blue what frames before it have found.
  void show_provenance() { shows_provenance_ = true; }

  /// From now on these are left to paths.
  void leave_to_paths(EdgesToPaths edges) { edges_ = edges; }

  /// From now on the surroundings light surfaces, but where a sample would see them it adds 1 to its slot here instead.
  void leave_open(float* open) { open_ = open; }

  /// From now on samples tell of their first surfaces, and of the light that has met none or shines from it: by slot, too.
  void describe(const FirstSurfaces& surfaces, float* seen) { surfaces_ = surfaces, seen_ = seen; }

  /// A primary ray per active lane: sample number sample[i] of pixel[i] of the panel, its light goes to slot[i] of the film.
  void primary(RayHitPacket& packet, const LaneMask& active, const std::uint32_t* pixel, const std::uint32_t* sample,
               const std::uint32_t* slot);

  /// Traces everything that waits.
  void finish_batch();

  RayCounts counts() const;

 private:
  void shade(const RayHitPacket& packet, const LaneMask& active);
  void shade_sky(const RayHitPacket& packet, int i, const PathRay& ray);
  void shade_surface(const RayHitPacket& packet, int i, const PathRay& ray);
  void add_emission(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f emission);
  void add_points(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray);
  void add_lights(LightGroups groups, const ShadingPoint& point, const Bsdf& bsdf, const Bsdf* gloss, Vec3f albedo,
                  const PathRay& ray);
  void reflect(const ShadingPoint& point, const Bsdf& gloss, const PathRay& ray, float length);
  void shine(const ShadingPoint& point, const Bsdf& bsdf, const LightSample& light, const PathRay& ray, ShadowQueue& queue);

  LaneMask phong_lanes() const;
  void shade_phong(const RayHitPacket& packet, LaneMask lanes);
  void light_phong(const RayPacket& view, const LaneMask& lanes, std::size_t light);
  void reflect_phong(const RayHitPacket& packet, const LaneMask& lanes);

  void ask(const RayHitPacket& packet, int i, Vec3f normal, Vec3f albedo, float length);
  void add_asked(const RayHitPacket& packet);
  void follow_path(const RayHitPacket& packet, int i);
  void trace_shadow_rays();
  void add_cached(std::uint32_t slot, Vec3f radiance, const LightPlace& place);
  void add(std::uint32_t slot, Vec3f radiance);
  void add_seen(const PathRay& ray, Vec3f radiance);
  void describe_first(const ShadingPoint& point, int i, const PathRay& ray);
  void deposit(std::uint32_t slot, Vec3f value);

  const DeviceScene::Impl& scene_;
  const LightCells& cells_;
  const LightCache& cache_;
  PathParams params_;
  float* film_;
  float* open_ = nullptr;  ///< by slot, too
  float* seen_ = nullptr;  ///< likewise; null: nobody asks for surfaces
  FirstSurfaces surfaces_{};
  bool shows_provenance_ = false;
  EdgesToPaths edges_ = EdgesToPaths::kNone;
  bool asks_points_alone_;  ///< lights that are asked at a diffuse surface are few and points
  RayCounts counts_;
  PathTracer paths_;  ///< where the cache knows nothing
  std::vector<PathRay> wave_, next_;
  std::array<ShadowQueue, kFewLights> to_point_;  ///< by light, where they are few: packets to one light stay together
  ShadowQueue to_others_;
  // Of the packet that is being shaded.
  PathLanes lanes_;
  SurfacePacket surface_;
  PhongLanes phong_;
  ShadowPacket shadow_;
  LightQueries queries_;  ///< what it asks the cache for,
  Lanes3 albedo_;         ///< and what becomes of that
};

}  // namespace lippmann
