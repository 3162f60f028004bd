// Records for the radiance cache: follows rays from the lens array to the first surface that scatters diffusely, and from there
// one path for the light that arrives. Where the cache knows light already, and nothing has moved since, the path may end in
// it at the next diffuse surface: the mean of many paths scatters less than one.
#pragma once

#include <optional>

#include "radiance/final_gather.hpp"
#include "trace/path_integrator.hpp"

namespace lippmann {

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

/// What paths of updates go by.
struct UpdatePaths {
  PathParams params;
  const TouchProbe* moved = nullptr;  ///< boxes around what has moved since the frame before; null: nothing is watched
  /// Resolved; paths end in it at the second diffuse surface. Null: they do not.
  const RadianceCache* ends = nullptr;
};

/// State of one thread at a time.
class CacheUpdate : public PathTracer<CacheUpdate> {
 public:
  /// Adds to `made`, which outlives this. sparse: makes records for these cells only; none: for all. With paths.moved, records
  /// tell what may have changed. With paths.ends, cells.lights_from is kSky or later.
  CacheUpdate(const ShadedScene& scene, const CacheCells& cells, const UpdatePaths& paths, std::optional<SparseCells> sparse,
              CacheRecords& made);

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
  void gather(const PathIntegrator::DiffuseVertex& at, const PathRay& ray, const std::optional<LightSample>& light, Vec2f way);
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
  Image light_;    ///< what arrives, by query
  Image deepest_;  ///< and what was scattered as often as may be
  std::vector<PathIntegrator::PossibleChange> changes_;
  PathIntegrator paths_;
  std::optional<FinalGather> ends_;
  std::vector<Query> queries_;
  std::array<std::uint32_t, kLanes> query_of_lane_{};  ///< of those of the packet that is being shaded which ask
};

}  // namespace lippmann
