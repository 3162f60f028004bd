// The radiance cache of a history, as one frame begins it or brings it up to date.
#pragma once

#include <optional>

#include "radiance/gather_frame.hpp"
#include "radiance/setup_search.hpp"
#include "radiance/update_frame.hpp"

namespace lippmann {

/// The cache grows to so many cells; smooth scenes need 0.1 to 0.2 of a pixel's, leaves of a pixel's size 0.5.
inline constexpr double kCellsPerPixel = 1.0;

/// What frames of a history know of its cells.
struct CacheHistory {
  std::optional<RadianceCache> cache;  ///< none: no frame yet
  float samples_per_cell = 0.0f;       ///< CacheCells::samples_per_cell, since the first frame
  LightGroup lights_from{};            ///< likewise
  int rounds = 0;                      ///< rounds of updates in the first frame
  float mean = 0.0f;                   ///< samples of a cell that it gave
  float enough = 0.0f;                 ///< samples of a cell that every frame sees to
};

/// Outlived by what it was made with.
class FrameCache {
 public:
  FrameCache(const Shot& shot, const SurfacePlaces& places, const TraceParams& params, const Workers& workers,
             CacheHistory& history);
  FrameCache(const FrameCache&) = delete;
  FrameCache& operator=(const FrameCache&) = delete;

  /// In a history's first frame: samples across the smallest cells that fit, as the first round of updates tells.
  float fitting_cell();
  /// Likewise: a cache with cells of this size, updated so often. What was found with the same cells counts.
  void set_up(const CacheSetup& setup, float fitting_cell);

  /// In a later frame: a little everywhere, and as much as the first frame was given where little is known: what was hidden
  /// before, and what has changed; then whatever it takes. moving: as CachedLightTracer::trace has it.
  void go_on(const std::vector<HorizonBox>& moving);

  /// Twice as many samples of a cell, and each attempt of a frame twice the updates of the last.
  void update_more(int attempt);

  /// Whether a history begins with this frame.
  bool is_first() const { return !moved_; }

  GatherSources sources() const { return {shot_, cells_, *history_.cache}; }

  /// All rays of updates.
  const RayCounts& counts() const { return counts_; }
  /// Those that brought what the cache holds now, in a history's first frame.
  std::uint64_t rays_since_start() const { return rays_since_start_; }
  double seconds_per_round() const;

 private:
  void start(float samples_per_cell, LightGroup lights_from);
  void update(int rounds);
  void update_sparse(PacketGroups sparse, int first_round, int end);
  double samples_per_cell() const;
  UpdateTarget target() const;

  Shot shot_;
  const ThreadPool& pool_;
  const Context& context_;
  CacheHistory& history_;
  BeamFootprint beam_;
  CacheCells cells_;
  CacheUpdater updater_;
  bool clamps_;          ///< light of single paths, which what many have left in the cache would escape
  int round_ = 0;        ///< the next round of updates
  float enough_ = 0.0f;  ///< samples of a cell, in this frame
  double update_seconds_ = 0.0;
  std::size_t records_ = 0;  ///< added since start()
  std::uint64_t rays_since_start_ = 0;
  std::optional<TouchProbe> moved_;
  RayCounts counts_;
};

}  // namespace lippmann
