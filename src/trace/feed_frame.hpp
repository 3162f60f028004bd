// Feeds the light cache with what a frame sees: rounds of rays from the lens array, some of the frame's pixels each. Private to
// src/trace.
#pragma once

#include <optional>

#include "trace/light_feeder.hpp"
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
};

/// By strip: groups of kRoundsPerFrame packets.
using PacketGroups = std::vector<std::vector<std::uint32_t>>;

struct Fed {
  RayCounts rays;
  std::size_t records = 0;
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

  /// The same; besides finds the groups of packets that meet cells of fewer than `enough` samples.
  Fed feed(const FeedTarget& target, int round, float enough, PacketGroups& scarce) const;

  /// A round of some groups, only for such cells; adds those that meet any to `still_scarce`, which is as long as `groups`.
  Fed feed_scarce(const FeedTarget& target, int round, float enough, const PacketGroups& groups,
                  PacketGroups& still_scarce) const;

 private:
  /// What a round does but for feeding all.
  struct Choice {
    std::optional<float> enough;
    const PacketGroups* only = nullptr;  ///< these, and only scarce cells; null: all
    PacketGroups* found = nullptr;
  };
  Fed feed(const FeedTarget& target, int round, const Choice& choice) const;
  std::vector<LightRecord> feed_strip(const FeedTarget& target, std::size_t strip, int round, const Choice& choice,
                                      RayCounts& counts) const;

  const DeviceScene::Impl& scene_;
  TraceParams params_;
  PacketSource source_;
};

}  // namespace lippmann
