#include "trace/feed_frame.hpp"

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

Fed FrameFeeder::feed(const FeedTarget& target, int round) const { return feed(target, round, Choice{}); }

Fed FrameFeeder::feed(const FeedTarget& target, int round, float enough, PacketGroups& scarce) const {
  scarce.assign(static_cast<std::size_t>(source_.strips()), {});
  return feed(target, round, {enough, nullptr, &scarce});
}

Fed FrameFeeder::feed_scarce(const FeedTarget& target, int round, float enough, const PacketGroups& groups,
                             PacketGroups& still_scarce) const {
  return feed(target, round, {enough, &groups, &still_scarce});
}

Fed FrameFeeder::feed(const FeedTarget& target, int round, const Choice& choice) const {
  const auto strips = static_cast<std::size_t>(source_.strips());
  std::vector<std::vector<LightRecord>> records(strips);
  std::vector<RayCounts> counts(strips);
  target.pool.for_each(strips, [&](std::size_t strip) {
    if (!target.context.cancelled) records[strip] = feed_strip(target, strip, round, choice, counts[strip]);
  });
  target.cache.add(records, target.pool);
  Fed fed;
  for (const RayCounts& c : counts) add(c, fed.rays);
  for (const std::vector<LightRecord>& of_strip : records) fed.records += of_strip.size();
  return fed;
}

/// Of every group the packet whose turn it is.
std::vector<LightRecord> FrameFeeder::feed_strip(const FeedTarget& target, std::size_t strip, int round, const Choice& choice,
                                                 RayCounts& counts) const {
  const auto seed = static_cast<std::uint32_t>(round);
  const PathParams paths{params_.max_depth, hash(params_.seed, params_.frame, 0x6c696768u + seed), params_.clamp_indirect};
  const int place = static_cast<int>(hash(params_.seed, params_.frame, seed) % kPlaces);
  const int turn = static_cast<int>((params_.frame + seed) % kRoundsPerFrame);
  const int groups = choice.only ? static_cast<int>((*choice.only)[strip].size())
                                 : (source_.packets_per_strip() + kRoundsPerFrame - 1) / kRoundsPerFrame;
  std::vector<LightRecord> records;
  LightFeeder feeder(scene_, target.cells, paths);
  if (choice.enough) feeder.look_for({target.cache, *choice.enough}, choice.only != nullptr);
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
    const std::size_t scarce_before = feeder.scarce_places();
    feeder.primary(packet, active, pixel);
    if (choice.found && feeder.scarce_places() - scarce_before >= kScarcePlaces) (*choice.found)[strip].push_back(group);
    if (++waiting < kPacketsPerBlock) continue;
    feeder.finish_group(records);
    feeder.begin_group(++random_group);
    waiting = 0;
  }
  feeder.finish_group(records);
  counts = feeder.counts();
  return records;
}

}  // namespace lippmann
