// Feeds the light cache with what a frame sees: rounds of rays from the lens array, some of the frame's pixels each. Private to
// src/trace.
#pragma once

#include "trace/cache_update.hpp"
#include "trace/packet_source.hpp"

namespace lippmann {

/// So many rounds follow a ray from every pixel: packets next to each other take turns.
inline constexpr int kRoundsPerFrame = 4;

/// What is fed, and who asks.
struct FeedTarget {
  const LightCells& cells;
  LightCache& cache;
  const ThreadPool& pool;
  const Context& context;
  const TouchProbe* moved = nullptr;  ///< boxes around what has moved since the frame before; null: nothing is doubtful
};

/// By strip: groups of kRoundsPerFrame packets.
using PacketGroups = std::vector<std::vector<std::uint32_t>>;

/// By strip; of every place the group of packets that has met it.
struct Fed {
  RayCounts rays;
  std::vector<FedLight> strips;
  std::size_t records() const;
};

/// Outlived by what it was made with.
class FrameFeeder {
 public:
  /// params: spp is not used.
  FrameFeeder(const DeviceScene::Impl& scene, const Optics& optics, const Affine3f& world_from_display,
              const TraceParams& params);

  /// Round number `round` of the frame: with kRoundsPerFrame or more, other rays of the same pixels. The cache has yet to
  /// resolve() what it was given. The same bits for any number of threads. Returns early, with some of the light, when
  /// context.cancelled is set.
  Fed feed(const FeedTarget& target, int round) const;

  /// A round of some groups, only for cells of fewer than `enough` samples.
  Fed feed_scarce(const FeedTarget& target, int round, float enough, const PacketGroups& groups) const;

 private:
  /// What a round does but for feeding all.
  struct Choice {
    float enough = 0.0f;
    const PacketGroups* only = nullptr;  ///< these, and only scarce cells; null: all
  };
  Fed feed(const FeedTarget& target, int round, const Choice& choice) const;
  RayCounts feed_strip(const FeedTarget& target, std::size_t strip, int round, const Choice& choice, FedLight& fed) const;

  const DeviceScene::Impl& scene_;
  TraceParams params_;
  PacketSource source_;
};

/// Adds to `groups` (by strip, ascending, each once) those that have met cells which now have fewer than `enough` samples.
void add_scarce_groups(const Fed& fed, const LightCache& cache, float enough, PacketGroups& groups);

}  // namespace lippmann
