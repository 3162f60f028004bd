#include "radiance/update_frame.hpp"

#include <algorithm>
#include <span>

#include "core/random.hpp"
#include "trace/frame_work.hpp"
#include "trace/trace_batch.hpp"

namespace lippmann {
namespace {

/// So many of a packet's places make it worth a packet more: cells that a surface only grazes are always sparse.
constexpr std::size_t kSparsePlaces = 4;

/// Sub-pixel places that these rays take in turn.
constexpr int kPlaces = 16;

}  // namespace

CacheUpdater::CacheUpdater(const Shot& shot, const TraceParams& params)
    : scene_(shot.device.shaded()),
      params_(params),
      source_(shot.optics, shot.world_from_display, params.order,
              SubPixel{params.seed, kPlaces, AngularFilter::kNone, params.lens}, shot.rows) {}

std::size_t UpdateRound::records() const {
  std::size_t count = 0;
  for (const CacheRecords& strip : strips) count += strip.records.size();
  return count;
}

UpdateRound CacheUpdater::update(const UpdateTarget& target, int round) const { return update(target, round, Choice{}); }

UpdateRound CacheUpdater::update_sparse(const UpdateTarget& target, int round, float enough, const PacketGroups& groups) const {
  return update(target, round, {enough, &groups});
}

UpdateRound CacheUpdater::update(const UpdateTarget& target, int round, const Choice& choice) const {
  const auto strips = static_cast<std::size_t>(source_.strips());
  UpdateRound made;
  made.strips.resize(strips);
  made.rays = trace_strips(strips, {target.pool, target.context, Progress::kSilent},
                           [&](std::size_t strip) { return update_strip(target, strip, round, choice, made.strips[strip]); });
  std::vector<std::span<const RadianceRecord>> records;
  records.reserve(strips);
  for (const CacheRecords& strip : made.strips) records.emplace_back(strip.records);
  target.cache.add(records, target.pool);
  return made;
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

/// Updates by the packet of every group whose turn it is.
RayCounts CacheUpdater::update_strip(const UpdateTarget& target, std::size_t strip, int round, const Choice& choice,
                                     CacheRecords& made) const {
  const auto seed = static_cast<std::uint32_t>(round);
  const PathParams paths{params_.max_depth, hash(params_.seed, params_.frame, 0x6c696768u + seed), params_.clamp_indirect};
  const int place = static_cast<int>(hash(params_.seed, params_.frame, seed) % kPlaces);
  GroupPackets packets{{source_, static_cast<int>(strip)},
                       static_cast<int>((params_.frame + seed) % kRoundsPerFrame),
                       (static_cast<std::uint32_t>(source_.first_strip()) + static_cast<std::uint32_t>(strip)) << 16};
  std::vector<int> groups;
  const auto list = [&](std::size_t group) {
    if (source_.lanes(packets.packets.strip, packets.packet_of(static_cast<int>(group))) > 0)
      groups.push_back(static_cast<int>(group));
  };
  if (choice.only)
    for (const std::uint32_t group : (*choice.only)[strip]) list(group);
  else
    for (int g = 0; g * kRoundsPerFrame < source_.packets_per_strip(); ++g) list(static_cast<std::size_t>(g));
  const std::optional<SparseCells> sparse =
      choice.only ? std::optional<SparseCells>({target.cache, choice.enough}) : std::nullopt;
  CacheUpdate update(scene_, target.cells, {paths, target.moved, target.paths_end ? &target.cache : nullptr}, sparse, made);
  for (std::span<const int> left = groups; !left.empty(); ++packets.stream, packets.samples = 0) {
    const std::span<const int> batch = left.first(std::min<std::size_t>(left.size(), kPacketsPerBlock));
    trace_batch(scene_, packets, {batch, place, place + 1}, update);
    left = left.subspan(batch.size());
  }
  return update.counts();
}

void add_sparse_groups(const UpdateRound& made, const RadianceCache& cache, float enough, PacketGroups& groups) {
  groups.resize(made.strips.size());
  for (std::size_t s = 0; s < made.strips.size(); ++s) {
    std::vector<std::uint32_t> sparse;
    for (std::size_t r = 0; r < made.strips[s].records.size(); ++r)
      if (cache.samples(made.strips[s].records[r].place) < enough) sparse.push_back(made.strips[s].sources[r]);
    std::sort(sparse.begin(), sparse.end());
    for (std::size_t i = 0; i + kSparsePlaces <= sparse.size(); ++i)
      if (sparse[i] == sparse[i + kSparsePlaces - 1]) groups[s].push_back(sparse[i]);
    std::sort(groups[s].begin(), groups[s].end());
    groups[s].erase(std::unique(groups[s].begin(), groups[s].end()), groups[s].end());
  }
}

}  // namespace lippmann
