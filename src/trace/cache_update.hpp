// Records for the radiance cache: follows rays from the lens array to the first surface that scatters diffusely, and from there
// one path for the light that arrives. Private to src/trace.
#pragma once

#include <optional>

#include "trace/path_integrator.hpp"
#include "trace/surface_places.hpp"

namespace lippmann {

/// What feeding and asking the cache have in common.
struct LightCells {
  const SurfacePlaces& places;
  const BeamFootprint& beam;
  float samples_per_cell = 8.0f;                ///< across the smallest cell
  LightGroup lights_from = LightGroup::kLamps;  ///< groups of lights from here on; those before it are asked at every point
  /// Edge of the smallest cell at the end of a path of some length, world units.
  float size(float path_length) const;
};

/// Places of which too little is known.
struct ScarceLight {
  const LightCache& cache;
  float enough;  ///< samples of a cell
  bool at(const LightPlace& place) const { return cache.samples(place) < enough; }
};

/// What was fed, and by which camera rays (CameraPacket::target).
struct FedLight {
  std::vector<LightRecord> records;
  std::vector<std::uint32_t> sources;
};

/// State of one thread at a time.
class CacheUpdate : public PathTracer<CacheUpdate> {
 public:
  /// Adds to `fed`, which outlives this. scarce: asks only where light is; none: everywhere. moved: boxes around what has moved
  /// since the frame before, to tell what is doubtful (LightRecord); null: nothing is.
  CacheUpdate(const DeviceScene::Impl& scene, const LightCells& cells, const PathParams& params,
              std::optional<ScarceLight> scarce, const TouchProbe* moved, FedLight& fed);

  /// Traces everything that waits, which has come from at most kPacketsPerBlock camera packets, and appends what arrived.
  void finish();

  RayCounts counts() const;

 private:
  friend class PathTracer<CacheUpdate>;
  static constexpr bool kSeesLight = false, kWidensBeams = false;

  LaneMask begin_packet(const RayHitPacket&, const LaneMask& active, const PathRay*) { return active; }
  void end_packet(const RayHitPacket&, const LaneMask&, const PathRay*) {}
  /// Drawn where they are asked for: most places are not scarce.
  static Vec2f numbers(const PathRay& ray, int, std::uint32_t pair) { return draw(ray, pair); }
  void vertex(const RayHitPacket& packet, int i, const PathRay& ray, const ShadingPoint& point, float length);
  void trace_shadow_rays() {}

  void ask(const RayHitPacket& packet, int i, const PathRay& ray, const ShadingPoint& point, const Bsdf& bsdf, float length,
           float pick);

  const LightCells& cells_;
  std::optional<ScarceLight> scarce_;
  bool watches_;
  FedLight& fed_;
  struct Query {
    LightPlace place;
    std::uint32_t source;
    bool moves;  ///< with the thing that it lies on
  };
  Image light_;  ///< what arrives, by query
  std::vector<PathIntegrator::Doubt> doubts_;
  PathIntegrator paths_;
  std::vector<Query> asked_;
};

}  // namespace lippmann
