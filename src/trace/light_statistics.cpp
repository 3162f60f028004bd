// What the light cache makes of its samples: how far cells are drawn to larger ones (empirical Bayes, with an analysis of
// variance), and what the past is worth when a frame begins.
#include <array>
#include <cmath>

#include "trace/light_cache.hpp"
#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

/// A history counts as this many samples at most: what drifts too slowly to be noticed is forgotten in the end.
constexpr float kLongestHistory = 2048.0f;
/// Means that differ by more than this many deviations do not differ by chance.
constexpr float kContradiction = 3.0f;

float squared(float x) { return x * x; }

}  // namespace

void LightCache::Moments::add(Vec3f light) {
  count += 1.0f;
  const float share = 1.0f / count;
  mean += share * (light - mean);
  square += share * (squared(luminance(light)) - square);
}

void LightCache::Moments::add(const Moments& more) {
  if (!(more.count > 0.0f)) return;
  count += more.count;
  const float share = more.count / count;
  mean += share * (more.mean - mean);
  square += share * (more.square - square);
}

float LightCache::Moments::variance() const { return std::max(0.0f, square - squared(luminance(mean))); }

LightCache::SlotsBySize LightCache::slots_by_size(const ThreadPool& pool) const {
  std::array<std::map<int, std::vector<std::uint32_t>>, kShards> of_shard;
  pool.for_each(kShards, [&](std::size_t s) {
    const Shard& shard = shards_[s];
    for (std::uint32_t i = 0; i < shard.slots.size(); ++i)
      if (shard.slots[i].key != 0) of_shard[s][shard.cells[shard.slots[i].cell].exponent].push_back(i);
  });
  SlotsBySize all;
  for (std::size_t s = 0; s < kShards; ++s)
    for (auto& [exponent, slots] : of_shard[s]) all[exponent][s] = std::move(slots);
  return all;
}

/// fn(cell, slot) for every cell of a size, side by side.
void LightCache::for_each_of_size(const ThreadPool& pool, const SlotsOfShards& slots, const auto& fn) {
  pool.for_each(kShards, [&](std::size_t s) {
    for (const std::uint32_t i : slots[s]) fn(shards_[s].cells[shards_[s].slots[i].cell], shards_[s].slots[i]);
  });
}

/// What the past is still worth, 0 ... 1, where it and what was fed last differ by more than chance explains.
float LightCache::contradicted(const Cell& cell) const {
  if (!(cell.now.count > 0.0f && cell.past.count > 0.0f)) return 1.0f;
  const float change = squared(luminance(cell.now.mean) - luminance(cell.past.mean));
  const float by_chance = cell.deviation * (1.0f / cell.now.count + 1.0f / cell.past.count);
  if (!(change > squared(kContradiction) * by_chance)) return 1.0f;
  // So many samples are as uncertain as the past is wrong.
  return std::min(1.0f, cell.deviation / (change - by_chance) / cell.past.count);
}

/// The same, where a cell has moved: light is taken to change as it does from cell to cell, whose centres are half a cell from
/// their parent's (its variance grows by this, as that of a Kalman filter's state does).
float LightCache::outdated(const Cell& cell, const Cell& parent, float moved) {
  const float cells = std::min(1.0f, std::ldexp(moved, -cell.exponent));
  const float change = 4.0f * parent.relief * squared(cells), count = cell.past.count + cell.now.count;
  return change > 0.0f ? cell.deviation / (cell.deviation + count * change) : 1.0f;
}

void LightCache::begin_frame(const Motion& moved, const ThreadPool& pool) {
  for (const auto& [exponent, slots] : slots_by_size(pool))
    for_each_of_size(pool, slots, [&](Cell& cell, Slot&) {
      const Cell* parent = parent_of(cell);
      cell.keep = std::min(parent ? parent->keep : 1.0f, contradicted(cell));
      cell.keep_all = parent ? std::min(parent->keep_all, outdated(cell, *parent, moved(cell.thing, cell.center))) : 1.0f;
    });
  pool.for_each(kShards, [&](std::size_t s) {
    for (Cell& cell : shards_[s].cells) {
      cell.past.count *= cell.keep;
      cell.past.add(cell.now);
      cell.past.count = std::min(cell.past.count * cell.keep_all, kLongestHistory);
      cell.now = {};
    }
  });
}

void LightCache::compare_with_wider(Cell& cell, Slot& slot) const {
  Moments all = cell.past;
  all.add(cell.now);
  const Cell* parent = parent_of(cell);
  // Few samples say little of how much they scatter.
  constexpr float kPrior = 8.0f;
  const float own = all.variance();
  cell.deviation = parent ? (all.count * own + kPrior * parent->deviation) / (all.count + kPrior) : own;
  cell.variance = cell.deviation / std::max(all.count, 1e-6f);
  cell.samples = all.count;
  cell.luminance = luminance(all.mean);
  slot.light = all.mean;
  cell.has_wider = false;
  if (!parent) return;
  const Vec4f around = look_up({cell.center, cell.thing, parent->part, std::ldexp(1.0f, cell.exponent + 1)});
  cell.has_wider = around.w > 0.0f;
  cell.wider = Vec3f(around);
}

/// By what the cells of a size differ from what larger ones say of them, beyond what chance explains (analysis of variance):
/// the spread of the larger ones.
void LightCache::find_spreads(const SlotsOfShards& slots, const SlotsOfShards* wider, const ThreadPool& pool) {
  struct Difference {
    std::uint32_t cell;
    float squares, from_mean, chance, count;
  };
  std::vector<std::array<std::vector<Difference>, kShards>> differences(kShards);
  pool.for_each(kShards, [&](std::size_t s) {
    for (const std::uint32_t i : slots[s]) {
      const Slot& slot = shards_[s].slots[i];
      const Cell& cell = shards_[s].cells[slot.cell];
      if (!cell.has_wider) continue;
      const auto [shard, index] = parent_index(cell);
      const Cell& parent = shards_[shard].cells[index];
      const float share = std::min(1.0f, cell.samples / std::max(parent.samples, 1.0f));
      differences[s][shard].push_back({index, cell.samples * squared(luminance(slot.light) - luminance(cell.wider)),
                                       cell.samples * squared(cell.luminance - parent.luminance),
                                       cell.deviation * (1.0f - share), cell.samples});
    }
  });
  if (!wider) return;
  pool.for_each(kShards, [&](std::size_t s) {
    std::vector<Difference> sums(shards_[s].cells.size());
    for (std::size_t from = 0; from < kShards; ++from)
      for (const Difference& d : differences[from][s]) {
        Difference& sum = sums[d.cell];
        sum.squares += d.squares, sum.from_mean += d.from_mean, sum.chance += d.chance, sum.count += d.count;
      }
    for (const std::uint32_t i : (*wider)[s]) {
      const std::uint32_t c = shards_[s].slots[i].cell;
      Cell& cell = shards_[s].cells[c];
      const float count = sums[c].count;
      const float found = count > 0.0f ? std::max(0.0f, sums[c].squares - sums[c].chance) / count : 0.0f;
      cell.relief = count > 0.0f ? std::max(0.0f, sums[c].from_mean - sums[c].chance) / count : 0.0f;
      // Light that changes evenly differs a quarter as much over half the distance.
      constexpr float kPrior = 8.0f;
      const Cell* wider = parent_of(cell);
      cell.spread = wider ? (count * found + kPrior * 0.25f * wider->spread) / (count + kPrior) : found;
    }
  });
}

/// Draws the cell's own mean towards what is around it, as far as both are as uncertain (empirical Bayes).
void LightCache::resolve(Cell& cell, Slot& slot) const {
  if (!cell.has_wider) return;
  const Cell* parent = parent_of(cell);
  const float spread = parent->spread + parent->variance;
  const float a = cell.variance / std::max(cell.variance + spread, 1e-30f);
  slot.light += a * (cell.wider - slot.light);
  cell.variance *= 1.0f - a;
}

void LightCache::resolve(const ThreadPool& pool) {
  const SlotsBySize by_size = slots_by_size(pool);
  for (const auto& [exponent, slots] : by_size) {
    for_each_of_size(pool, slots, [&](Cell& cell, Slot& slot) { compare_with_wider(cell, slot); });
    const auto wider = by_size.find(exponent + 1);
    find_spreads(slots, wider != by_size.end() ? &wider->second : nullptr, pool);
    for_each_of_size(pool, slots, [&](Cell& cell, Slot& slot) { resolve(cell, slot); });
  }
}

}  // namespace lippmann
