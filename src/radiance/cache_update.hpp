// Records for the radiance cache: follows rays from the lens array to the first surface that scatters diffusely, and from there
// one path for the light that arrives.
#pragma once

#include <optional>

#include "radiance/surface_places.hpp"
#include "trace/path_integrator.hpp"

namespace lippmann {

/// How points of surfaces find their cells, in updates and look-ups alike.
struct CacheCells {
  const SurfacePlaces& places;
  const BeamFootprint& beam;
  float samples_per_cell = 8.0f;                ///< across the smallest cell
  LightGroup lights_from = LightGroup::kLamps;  ///< groups of lights from here on; those before it are asked at every point
  /// Edge of the smallest cell at the end of a path of some length, world units.
  float size(float path_length) const;
};

/// Cells that have too few samples.
struct SparseCells {
  const RadianceCache& cache;
  float enough;  ///< samples of a cell
  bool at(const CachePoint& place) const { return cache.samples(place) < enough; }
};

/// Records, and the camera rays that each comes from (CameraPacket::target).
struct CacheRecords {
  std::vector<RadianceRecord> records;
  std::vector<std::uint32_t> sources;
};

/// State of one thread at a time.
class CacheUpdate : public PathTracer<CacheUpdate> {
 public:
  /// Adds to `made`, which outlives this. sparse: makes records for these cells only; none: for all. moved: boxes around what
  /// has moved since the frame before, to tell what may have changed (RadianceRecord); null: nothing is.
  CacheUpdate(const ShadedScene& scene, const CacheCells& cells, const PathParams& params, std::optional<SparseCells> sparse,
              const TouchProbe* moved, CacheRecords& made);

  /// Traces everything that waits, which has come from at most kPacketsPerBlock camera packets, and appends what arrived.
  void finish();

  RayCounts counts() const;

 private:
  friend class PathTracer<CacheUpdate>;
  static constexpr bool kSeesLight = false, kWidensBeams = false;

  LaneMask begin_packet(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays);
  void end_packet(const RayHitPacket&, const PathRay*) {}
  void scatter(const RayHitPacket& packet, const PathRay* rays);
  void trace_shadow_rays() {}

  bool ask(const RayHitPacket& packet, int i, const PathRay& ray);
  void gather(const LaneMask& lanes, const PathRay* rays);
  void pass_on(const LaneMask& lanes, const Lanes& lobe, const PathRay* rays);

  const CacheCells& cells_;
  std::optional<SparseCells> sparse_;
  bool watches_;
  CacheRecords& made_;
  struct Query {
    CachePoint place;
    std::array<std::uint32_t, 2> also;  ///< RadianceRecord's
    std::uint32_t source;
    bool moves;  ///< with the thing that it lies on
  };
  Image light_;  ///< what arrives, by query
  std::vector<PathIntegrator::PossibleChange> changes_;
  PathIntegrator paths_;
  std::vector<Query> queries_;
  std::array<std::uint32_t, kLanes> query_of_lane_{};  ///< of those of the packet that is being shaded which ask
};

}  // namespace lippmann
