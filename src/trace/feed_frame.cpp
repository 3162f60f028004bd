#include "trace/feed_frame.hpp"

#include <algorithm>

#include "core/random.hpp"

namespace lippmann {
namespace {

/// Of a packet, to be worth a packet more: cells that a surface only grazes are always scarce.
constexpr std::size_t kScarcePlaces = 4;

/// Sub-pixel places that these rays take in turn.
constexpr int kPlaces = 16;

}  // namespace

FrameFeeder::FrameFeeder(const DeviceScene::Impl& scene, const Optics& optics, const Affine3f& world_from_display,
                         const TraceParams& params)
    : scene_(scene),
      params_(params),
      source_(optics, world_from_display, params.order, SubPixel{params.seed, kPlaces, AngularFilter::kNone}) {}

std::size_t Fed::records() const {
  std::size_t count = 0;
  for (const FedLight& strip : strips) count += strip.records.size();
  return count;
}

Fed FrameFeeder::feed(const FeedTarget& target, int round) const { return feed(target, round, Choice{}); }

Fed FrameFeeder::feed_scarce(const FeedTarget& target, int round, float enough, const PacketGroups& groups) const {
  return feed(target, round, {enough, &groups});
}

Fed FrameFeeder::feed(const FeedTarget& target, int round, const Choice& choice) const {
  const auto strips = static_cast<std::size_t>(source_.strips());
  Fed fed;
  fed.strips.resize(strips);
  std::vector<RayCounts> counts(strips);
  target.pool.for_each(strips, [&](std::size_t strip) {
    if (!target.context.cancelled) fed.strips[strip] = feed_strip(target, strip, round, choice, counts[strip]);
  });
  std::vector<std::span<const LightRecord>> records;
  records.reserve(strips);
  for (const FedLight& strip : fed.strips) records.emplace_back(strip.records);
  target.cache.add(records, target.pool);
  for (const RayCounts& c : counts) add(c, fed.rays);
  return fed;
}

/// Of every group the packet whose turn it is.
FedLight FrameFeeder::feed_strip(const FeedTarget& target, std::size_t strip, int round, const Choice& choice,
                                 RayCounts& counts) const {
  const auto seed = static_cast<std::uint32_t>(round);
  const PathParams paths{params_.max_depth, hash(params_.seed, params_.frame, 0x6c696768u + seed), params_.clamp_indirect};
  const int place = static_cast<int>(hash(params_.seed, params_.frame, seed) % kPlaces);
  const int turn = static_cast<int>((params_.frame + seed) % kRoundsPerFrame);
  const int groups = choice.only ? static_cast<int>((*choice.only)[strip].size())
                                 : (source_.packets_per_strip() + kRoundsPerFrame - 1) / kRoundsPerFrame;
  FedLight fed;
  LightFeeder feeder(scene_, target.cells, paths);
  if (choice.only) feeder.ask_only({target.cache, choice.enough});
  if (target.moved) feeder.watch(*target.moved);
  RayHitPacket packet;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  auto random_group = static_cast<std::uint32_t>(strip) << 16;
  feeder.begin_group(random_group);
  int waiting = 0;
  for (int g = 0; g < groups; ++g) {
    const std::uint32_t group =
        choice.only ? (*choice.only)[strip][static_cast<std::size_t>(g)] : static_cast<std::uint32_t>(g);
    const int p = static_cast<int>(group) * kRoundsPerFrame + turn;
    if (p >= source_.packets_per_strip() || source_.fill(static_cast<int>(strip), p, place, packet.ray, active, pixel) == 0)
      continue;
    feeder.primary(packet, active, group);
    if (++waiting < kPacketsPerBlock) continue;
    feeder.finish_group(fed);
    feeder.begin_group(++random_group);
    waiting = 0;
  }
  feeder.finish_group(fed);
  counts = feeder.counts();
  return fed;
}

void add_scarce_groups(const Fed& fed, const LightCache& cache, float enough, PacketGroups& groups) {
  groups.resize(fed.strips.size());
  for (std::size_t s = 0; s < fed.strips.size(); ++s) {
    std::vector<std::uint32_t> scarce;
    for (std::size_t r = 0; r < fed.strips[s].records.size(); ++r)
      if (cache.samples(fed.strips[s].records[r].place) < enough) scarce.push_back(fed.strips[s].sources[r]);
    std::sort(scarce.begin(), scarce.end());
    for (std::size_t i = 0; i + kScarcePlaces <= scarce.size(); ++i)
      if (scarce[i] == scarce[i + kScarcePlaces - 1]) groups[s].push_back(scarce[i]);
    std::sort(groups[s].begin(), groups[s].end());
    groups[s].erase(std::unique(groups[s].begin(), groups[s].end()), groups[s].end());
  }
}

}  // namespace lippmann
