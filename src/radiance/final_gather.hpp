// Final gather: paths that end in the radiance cache. From the lens array to surfaces, mirrors and glass they are exact; lights
// that the cache does not hold are sampled by shadow rays, all other light on diffuse surfaces is looked up.
#pragma once

#include <array>

#include "radiance/cache_cells.hpp"
#include "radiance/phong_lanes.hpp"
#include "radiance/radiance_cache.hpp"
#include "trace/path_integrator.hpp"

namespace lippmann {

/// So many point-like lights are all sampled at every point, and make no noise; of more of them, one.
inline constexpr std::size_t kFewLights = 4;

struct FinalGatherOptions {
  EdgesToPaths edges = EdgesToPaths::kNone;  ///< these are left to paths
  LookedUp light = LookedUp::kAll;
  /// Pictures show where light came from, in proportion to it: red what this frame traced, green what the cache received in
  /// this frame, blue what it has from frames before.
  bool provenance = false;
  float* paths = nullptr;  ///< by slot, receives how many paths its sample was left to; null: nobody asks
  /// By slot, luminance is added to it that was looked up: what the cache received in this frame, and what it has from frames
  /// before. Null: nobody asks.
  Vec2f* looked_up = nullptr;
};

/// State of one thread at a time.
class FinalGather : public PathTracer<FinalGather> {
 public:
  /// Every sample adds its light as a whole to its slot of the film: params.spp is 1, and parts of the light are not told
  /// apart.
  FinalGather(const ShadedScene& scene, const CacheCells& cells, const RadianceCache& cache, const PathParams& params,
              const PathFilm& film, const FinalGatherOptions& options);

  /// A path that comes from a surface which has asked for lights of the sky, or for none (PathIntegrator::bounce).
  void take(const PathRay& path) { next_.push_back(path); }

  /// Traces everything that waits.
  void finish();

  RayCounts counts() const;

 private:
  friend class PathTracer<FinalGather>;
  static constexpr bool kSeesLight = true, kWidensBeams = false;

  LaneMask begin_packet(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays);
  void end_packet(const RayHitPacket& packet, const PathRay* rays);
  /// A vertex asks for one light of every group.
  float chance(LightGroups groups, const LightReceiver& at) const { return lights().chance(groups, at); }
  /// And for each lamp that has a size, where they are few.
  float chance_of_round(std::size_t k, const LightReceiver& at) const {
    return asks_all_rounds() ? lights().chance_of_round(k, at) : lights().chance(kRoundLights, at);
  }
  bool asks_all_rounds() const { return lights().rounds() <= kFewLights; }
  void scatter(const RayHitPacket& packet, const PathRay* rays);
  void end_path(const PathRay& ray, Vec3f radiance) { add_traced(ray.pixel, radiance, ray.surfaces()); }
  void trace_shadow_rays();

  void add_points(const PathRay* rays);
  void add_rounds(const PathRay* rays);
  void add_lights(LightGroups groups, const PathRay* rays);
  void add_light(int i, const LightSample& light, const BsdfValue& value, bool over_diffuse, const PathRay& ray);
  void reflect(const LaneMask& lanes, const PathRay* rays);
  void shine(int i, const LightSample& light, const BsdfValue& value, const PathRay& ray, ShadowQueue& queue);

  // Phong's surfaces, side by side where all lights that are sampled are points.
  LaneMask phong_lanes() const;
  void shade_phong(const RayHitPacket& packet, LaneMask lanes, const PathRay* rays);
  void light_phong(const RayPacket& view, const LaneMask& lanes, std::size_t light);
  void reflect_phong(const RayHitPacket& packet, const LaneMask& lanes, const PathRay* rays);

  void ask_cache(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f normal, Vec3f albedo, float length);
  void follow_paths(const RayHitPacket& packet, const LaneMask& lanes, const PathRay* rays);
  void add_cached(const PathRay& ray, Vec3f radiance, const CachePoint& place);
  void add_traced(std::uint32_t slot, Vec3f radiance, int depth);

  /// Reflections that are at most 1 / this of the picture are left to chance.
  static constexpr float kFaint = 8.0f;

  const CacheCells& cells_;
  const RadianceCache& cache_;
  FinalGatherOptions options_;
  bool samples_points_alone_;                     ///< lights that are sampled at a diffuse surface are few and points
  PathIntegrator paths_;                          ///< where the cache knows nothing
  std::array<ShadowQueue, kFewLights> to_point_;  ///< by light, where they are few: packets to one light stay together
  ShadowQueue to_others_;
  // What follows belongs to the packet that is being shaded.
  PathLanes lanes_{};  ///< paths that have met Phong's surfaces
  PhongLanes phong_;
  ShadowPacket shadow_;
  CacheQueries queries_;  ///< what it asks the cache for,
  Lanes3 albedo_;         ///< and what becomes of that
  LaneMask rough_;        ///< vertices with lobes that are neither diffuse nor sharp
  BsdfPacket whole_;      ///< surfaces that paths are followed from: those of vertices_ have lost their diffuse part
};

}  // namespace lippmann
