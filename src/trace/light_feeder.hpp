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

/// State of one thread at a time.
class LightFeeder {
 public:
  LightFeeder(const DeviceScene::Impl& scene, const LightCells& cells, const PathParams& params);

  /// From now on random numbers are those of this group of packets: another number for each.
  void begin_group(std::uint32_t group);

  /// From now on counts the places of scarce light that are met; only_there: and asks nowhere else.
  void look_for(const ScarceLight& scarce, bool only_there) { scarce_.emplace(scarce), asks_only_there_ = only_there; }
  std::size_t scarce_places() const { return scarce_places_; }

  /// Traces a packet of primary rays; queries that go on from there wait for finish_group().
  void primary(RayHitPacket& packet, const LaneMask& active, const std::uint32_t* pixel);

  /// Traces all that waits, and appends what arrived.
  void finish_group(std::vector<LightRecord>& records);

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
  bool asks_only_there_ = false;
  std::size_t scarce_places_ = 0;
  Image light_;  ///< what arrives, by query of the group
  PathTracer paths_;
  std::vector<LightPlace> asked_;
  std::vector<PathRay> wave_, next_;
  SurfacePacket surface_;
};

}  // namespace lippmann
