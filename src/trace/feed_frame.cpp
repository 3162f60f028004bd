#include "trace/feed_frame.hpp"

#include <algorithm>
#include <span>

#include "core/random.hpp"
#include "trace/frame_work.hpp"
#include "trace/trace_batch.hpp"

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
  fed.rays = trace_strips(strips, {target.pool, target.context}, Progress::kSilent,
                          [&](std::size_t strip) { return feed_strip(target, strip, round, choice, fed.strips[strip]); });
  std::vector<std::span<const LightRecord>> records;
  records.reserve(strips);
  for (const FedLight& strip : fed.strips) records.emplace_back(strip.records);
  target.cache.add(records, target.pool);
  return fed;
}

namespace {

/// The packets of a strip whose turn it is, by group, for trace_batch(). Random numbers are those of a stream of the batch's
/// own.
struct GroupPackets {
  StripPackets packets;
  int turn;
  std::uint32_t stream, samples = 0;

  int packet_of(int group) const { return group * kRoundsPerFrame + turn; }

  bool fill(int group, int place, CameraPacket& into) {
    if (!packets.fill(packet_of(group), place, into)) return false;
    for (int i = 0; i < kLanes; ++i) {
      into.target[i] = static_cast<std::uint32_t>(group);
      into.stream[i] = stream;
      into.sample[i] = samples;
      samples += into.active.lane[i] ? 1 : 0;
    }
    return true;
  }
};

}  // namespace

/// Of every group the packet whose turn it is.
RayCounts FrameFeeder::feed_strip(const FeedTarget& target, std::size_t strip, int round, const Choice& choice,
                                  FedLight& fed) const {
  const auto seed = static_cast<std::uint32_t>(round);
  const PathParams paths{params_.max_depth, hash(params_.seed, params_.frame, 0x6c696768u + seed), params_.clamp_indirect};
  const int place = static_cast<int>(hash(params_.seed, params_.frame, seed) % kPlaces);
  GroupPackets packets{{source_, static_cast<int>(strip)},
                       static_cast<int>((params_.frame + seed) % kRoundsPerFrame),
                       static_cast<std::uint32_t>(strip) << 16};
  std::vector<int> groups;
  const auto list = [&](std::size_t group) {
    if (source_.lanes(packets.packets.strip, packets.packet_of(static_cast<int>(group))) > 0)
      groups.push_back(static_cast<int>(group));
  };
  if (choice.only)
    for (const std::uint32_t group : (*choice.only)[strip]) list(group);
  else
    for (int g = 0; g * kRoundsPerFrame < source_.packets_per_strip(); ++g) list(static_cast<std::size_t>(g));
  const std::optional<ScarceLight> scarce =
      choice.only ? std::optional<ScarceLight>({target.cache, choice.enough}) : std::nullopt;
  CacheUpdate update(scene_, target.cells, paths, scarce, target.moved, fed);
  for (std::span<const int> left = groups; !left.empty(); ++packets.stream, packets.samples = 0) {
    const std::span<const int> batch = left.first(std::min<std::size_t>(left.size(), kPacketsPerBlock));
    trace_batch(scene_, packets, {batch, place, place + 1}, update);
    left = left.subspan(batch.size());
  }
  return update.counts();
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
