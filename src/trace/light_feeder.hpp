// Feeds the light cache: follows rays from the lens array to the first surface that scatters diffusely, and from there one path
// for the light that arrives. Private to src/trace.
#pragma once

#include "trace/path_tracer.hpp"
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

/// What was fed, and by which primary rays (LightFeeder::primary).
struct FedLight {
  std::vector<LightRecord> records;
  std::vector<std::uint32_t> sources;
};

/// State of one thread at a time.
class LightFeeder {
 public:
  LightFeeder(const DeviceScene::Impl& scene, const LightCells& cells, const PathParams& params);

  /// From now on random numbers are those of this group of packets: another number for each.
  void begin_group(std::uint32_t group);

  /// From now on asks only where light is scarce.
  void ask_only(const ScarceLight& scarce) { scarce_.emplace(scarce); }

  /// From now on tells what is doubtful (LightRecord): boxes are around what has moved since the frame before.
  void watch(const TouchProbe& moved) { paths_.watch(moved, doubts_), watches_ = true; }

  /// Traces a packet of primary rays; queries that go on from there wait for finish_group(). source: a number of the caller's.
  void primary(RayHitPacket& packet, const LaneMask& active, std::uint32_t source);

  /// Traces all that waits, and appends what arrived.
  void finish_group(FedLight& fed);

  RayCounts counts() const;

 private:
  void shade(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays);
  void shade_lane(const RayHitPacket& packet, int i, const PathRay& ray);

  const DeviceScene::Impl& scene_;
  const LightCells& cells_;
  PathParams params_;
  std::uint32_t group_ = 0, started_ = 0;  ///< of the group
  RayCounts counts_;
  std::optional<ScarceLight> scarce_;
  bool watches_ = false;
  struct Query {
    LightPlace place;
    std::uint32_t source;
    bool moves;  ///< with the thing that it lies on
  };
  Image light_;  ///< what arrives, by query of the group
  std::vector<PathTracer::Doubt> doubts_;
  PathTracer paths_;
  std::vector<Query> asked_;
  std::vector<PathRay> wave_, next_;
  SurfacePacket surface_;
};

}  // namespace lippmann
