// Updates the radiance cache with what a frame sees: rounds of rays from the lens array, some of the frame's pixels each.
#pragma once

#include "radiance/cache_update.hpp"
#include "trace/packet_source.hpp"

namespace lippmann {

/// So many rounds follow a ray from every pixel: packets next to each other take turns.
inline constexpr int kRoundsPerFrame = 4;

/// What is updated, and who works.
struct UpdateTarget {
  const CacheCells& cells;
  RadianceCache& cache;
  const ThreadPool& pool;
  const Context& context;
  const TouchProbe* moved = nullptr;  ///< boxes around what has moved since the frame before; null: nothing has
  bool paths_end = false;             ///< in the cache, which is resolved: UpdatePaths::ends
};

/// By strip: groups of kRoundsPerFrame packets.
using PacketGroups = std::vector<std::vector<std::uint32_t>>;

/// By strip; of every place the group of packets that has met it.
struct UpdateRound {
  RayCounts rays;
  std::vector<CacheRecords> strips;
  std::size_t records() const;
};

/// Outlived by what it was made with.
class CacheUpdater {
 public:
  /// params: spp is not used.
  CacheUpdater(const Shot& shot, const TraceParams& params);

  /// Round number `round` of the frame: with kRoundsPerFrame or more, other rays of the same pixels. The cache has yet to
  /// resolve() what it was given. The same bits for any number of threads. Returns early, with some of the light, when
  /// context.cancelled is set.
  UpdateRound update(const UpdateTarget& target, int round) const;

  /// A round of some groups, only for cells of fewer than `enough` samples.
  UpdateRound update_sparse(const UpdateTarget& target, int round, float enough, const PacketGroups& groups) const;

 private:
  /// Which packets of a round are traced, and for which cells.
  struct Choice {
    float enough = 0.0f;
    const PacketGroups* only = nullptr;  ///< these, and only sparse cells; null: all
  };
  UpdateRound update(const UpdateTarget& target, int round, const Choice& choice) const;
  RayCounts update_strip(const UpdateTarget& target, std::size_t strip, int round, const Choice& choice,
                         CacheRecords& made) const;

  const ShadedScene& scene_;
  TraceParams params_;
  PacketSource source_;
};

/// Adds to `groups` (by strip, ascending, each once) those that have met cells which now have fewer than `enough` samples.
void add_sparse_groups(const UpdateRound& made, const RadianceCache& cache, float enough, PacketGroups& groups);

}  // namespace lippmann
