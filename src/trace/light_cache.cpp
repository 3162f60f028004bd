#include "trace/light_cache.hpp"

#include <bit>
#include <cmath>

#include "transport/bsdf.hpp"
#include "transport/sampling.hpp"

namespace lippmann {
namespace {

/// Cells from this level on hold all parts of a thing.
constexpr int kJointLevel = 2;
constexpr std::uint32_t kAllParts = 0xFFFFFFFFu;
/// A history counts as this many samples at most: what drifts too slowly to be noticed is forgotten in the end.
constexpr float kLongestHistory = 2048.0f;
/// Means that differ by more than this many deviations do not differ by chance.
constexpr float kContradiction = 3.0f;

std::uint64_t mixed(std::uint64_t x) {  // Stafford's mix 13
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

int exponent_of(float size, int level) {
  // What is not a number, too, ends at the least.
  return std::ilogb(size > 1e-30f ? std::min(size, 1e30f) : 1e-30f) + level;
}

std::uint32_t part_at(std::uint32_t part, int level) { return level < kJointLevel ? part : kAllParts; }

std::uint64_t base_key(std::uint32_t thing, std::uint32_t part, int exponent) {
  return mixed((static_cast<std::uint64_t>(thing) << 32 | part) + mixed(static_cast<std::uint64_t>(exponent + 1024)));
}

std::uint64_t key_of(std::uint64_t base, glm::i64vec3 at) {
  const auto x = static_cast<std::uint64_t>(at.x), y = static_cast<std::uint64_t>(at.y), z = static_cast<std::uint64_t>(at.z);
  return mixed(base + x * 0x9e3779b97f4a7c15ull + y * 0xc2b2ae3d27d4eb4full + z * 0x165667b19e3779f9ull) | 1u;
}

std::size_t shard_of(std::uint64_t key) { return key >> 58; }

/// Far beyond any scene's cells coordinates have no digits left for them: they all end in one.
glm::i64vec3 cell_at(Vec3f p) { return glm::i64vec3(glm::clamp(glm::floor(p), Vec3f(-1e15f), Vec3f(1e15f))); }

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

const LightCache::Slot* LightCache::Shard::find(std::uint64_t key) const {
  if (slots.empty()) return nullptr;
  const std::size_t mask = slots.size() - 1;
  for (std::size_t i = key & mask;; i = (i + 1) & mask) {
    if (slots[i].key == key) return &slots[i];
    if (slots[i].key == 0) return nullptr;
  }
}

void LightCache::Shard::put(std::uint64_t key, std::uint32_t cell) {
  const std::size_t mask = slots.size() - 1;
  std::size_t i = key & mask;
  while (slots[i].key != 0) i = (i + 1) & mask;
  slots[i].key = key;
  slots[i].cell = cell;
}

void LightCache::Shard::reserve(std::size_t wanted) {
  if (2 * wanted <= slots.size()) return;
  std::vector<Slot> old(std::bit_ceil(std::max<std::size_t>(64, 3 * wanted)));
  old.swap(slots);
  for (const Slot& slot : old)
    if (slot.key != 0) put(slot.key, slot.cell);
}

/// Null where the cell is not known and there is no room for it.
LightCache::Cell* LightCache::Shard::find_or_add(std::uint64_t key, std::size_t most_cells, bool& is_new) {
  const Slot* slot = find(key);
  is_new = slot == nullptr;
  if (slot) return &cells[slot->cell];
  if (cells.size() >= most_cells) return nullptr;
  reserve(cells.size() + 1);
  put(key, static_cast<std::uint32_t>(cells.size()));
  return &cells.emplace_back();
}

LightCache::LightCache(std::size_t most_cells) : shards_(kShards), most_cells_((most_cells + kShards - 1) / kShards) {}

const LightCache::Slot* LightCache::find(std::uint64_t key) const { return shards_[shard_of(key)].find(key); }

const LightCache::Cell* LightCache::cell_of(std::uint64_t key) const {
  const Slot* slot = find(key);
  return slot ? &shards_[shard_of(key)].cells[slot->cell] : nullptr;
}

std::pair<std::size_t, std::uint32_t> LightCache::parent_index(const Cell& cell) const {
  const glm::i64vec3 at = cell_at(cell.center * std::ldexp(1.0f, -(cell.exponent + 1)));
  for (const std::uint32_t part : {cell.part, kAllParts}) {
    const std::uint64_t key = key_of(base_key(cell.thing, part, cell.exponent + 1), at);
    if (const Slot* slot = find(key)) return {shard_of(key), slot->cell};
  }
  return {kShards, 0};
}

const LightCache::Cell* LightCache::parent_of(const Cell& cell) const {
  const auto [shard, index] = parent_index(cell);
  return shard < kShards ? &shards_[shard].cells[index] : nullptr;
}

void LightCache::add(std::span<const std::vector<LightRecord>> records, const ThreadPool& pool) {
  struct Target {
    std::uint64_t key;
    std::uint32_t record;
    std::uint32_t level;
  };
  std::vector<std::array<std::vector<Target>, kShards>> targets(records.size());
  pool.for_each(records.size(), [&](std::size_t piece) {
    for (std::uint32_t r = 0; r < records[piece].size(); ++r) {
      const LightPlace& place = records[piece][r].place;
      for (int level = 0; level < kLevels; ++level) {
        const int exponent = exponent_of(place.size, level);
        const std::uint64_t key = key_of(base_key(place.thing, part_at(place.part, level), exponent),
                                         cell_at(place.position * std::ldexp(1.0f, -exponent)));
        targets[piece][shard_of(key)].push_back({key, r, static_cast<std::uint32_t>(level)});
      }
    }
  });
  pool.for_each(kShards, [&](std::size_t s) {
    for (std::size_t piece = 0; piece < records.size(); ++piece)
      for (const Target& target : targets[piece][s]) {
        const LightRecord& record = records[piece][target.record];
        // Products of sound numbers may overflow on a path: one such would be seen wherever its cells are.
        if (!std::isfinite(luminance(record.light))) continue;
        const int level = static_cast<int>(target.level);
        bool is_new = false;
        Cell* found = shards_[s].find_or_add(target.key, most_cells_, is_new);
        if (!found) continue;
        Cell& cell = *found;
        if (is_new) {
          cell.thing = record.place.thing;
          cell.part = part_at(record.place.part, level);
          cell.exponent = exponent_of(record.place.size, level);
          const float edge = std::ldexp(1.0f, cell.exponent);
          cell.center = (Vec3f(cell_at(record.place.position / edge)) + 0.5f) * edge;
        }
        cell.now.add(record.light);
      }
  });
}

void LightCache::exponents(int& least, int& most) const {
  least = 4096, most = -4096;
  for (const Shard& shard : shards_)
    for (const Cell& cell : shard.cells) least = std::min(least, cell.exponent), most = std::max(most, cell.exponent);
}

/// fn(cell, slot) for every cell of a size, side by side.
void LightCache::for_each_of_size(const ThreadPool& pool, int exponent, const auto& fn) {
  pool.for_each(kShards, [&](std::size_t s) {
    for (Slot& slot : shards_[s].slots)
      if (slot.key != 0 && shards_[s].cells[slot.cell].exponent == exponent) fn(shards_[s].cells[slot.cell], slot);
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
  int least = 0, most = -1;
  exponents(least, most);
  for (int exponent = most; exponent >= least; --exponent)
    for_each_of_size(pool, exponent, [&](Cell& cell, Slot&) {
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
void LightCache::find_spreads(int exponent, const ThreadPool& pool) {
  struct Difference {
    std::uint32_t cell;
    float squares, from_mean, chance, count;
  };
  std::vector<std::array<std::vector<Difference>, kShards>> differences(kShards);
  pool.for_each(kShards, [&](std::size_t s) {
    for (const Slot& slot : shards_[s].slots) {
      if (slot.key == 0) continue;
      const Cell& cell = shards_[s].cells[slot.cell];
      if (cell.exponent != exponent || !cell.has_wider) continue;
      const auto [shard, index] = parent_index(cell);
      const Cell& parent = shards_[shard].cells[index];
      const float share = std::min(1.0f, cell.samples / std::max(parent.samples, 1.0f));
      differences[s][shard].push_back({index, cell.samples * squared(luminance(slot.light) - luminance(cell.wider)),
                                       cell.samples * squared(cell.luminance - parent.luminance),
                                       cell.deviation * (1.0f - share), cell.samples});
    }
  });
  pool.for_each(kShards, [&](std::size_t s) {
    std::vector<Difference> sums(shards_[s].cells.size());
    for (std::size_t from = 0; from < kShards; ++from)
      for (const Difference& d : differences[from][s]) {
        Difference& sum = sums[d.cell];
        sum.squares += d.squares, sum.from_mean += d.from_mean, sum.chance += d.chance, sum.count += d.count;
      }
    for (std::size_t c = 0; c < sums.size(); ++c) {
      Cell& cell = shards_[s].cells[c];
      if (cell.exponent != exponent + 1) continue;
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
  int least = 0, most = -1;
  exponents(least, most);
  for (int exponent = most; exponent >= least; --exponent) {
    for_each_of_size(pool, exponent, [&](Cell& cell, Slot& slot) { compare_with_wider(cell, slot); });
    find_spreads(exponent, pool);
    for_each_of_size(pool, exponent, [&](Cell& cell, Slot& slot) { resolve(cell, slot); });
  }
}

Vec4f LightCache::pick(const LightPlace& place, Vec3f normal, Vec2f u) const {
  const Frame frame(normal);
  const Vec2f shift = u - 0.5f;
  for (int level = 0; level < kLevels; ++level) {
    const int exponent = exponent_of(place.size, level);
    const float edge = std::ldexp(1.0f, exponent), scale = std::ldexp(1.0f, -exponent);
    const std::uint64_t base = base_key(place.thing, part_at(place.part, level), exponent);
    const Vec3f shifted = place.position + edge * (shift.x * frame.x + shift.y * frame.y);
    const Slot* slot = find(key_of(base, cell_at(shifted * scale)));
    if (!slot) slot = find(key_of(base, cell_at(place.position * scale)));
    if (slot) return Vec4f(slot->light, 1.0f);
  }
  return Vec4f(0.0f);
}

LightCache::Interpolated LightCache::interpolate(Vec3f p, std::uint64_t base, int exponent) const {
  const Vec3f q = p * std::ldexp(1.0f, -exponent) - 0.5f;
  const Vec3f lower = glm::floor(q), f = q - lower;
  const glm::i64vec3 at = cell_at(q);
  Interpolated result;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::i64vec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
    const Vec3f w(step.x ? f.x : 1.0f - f.x, step.y ? f.y : 1.0f - f.y, step.z ? f.z : 1.0f - f.z);
    const float weight = w.x * w.y * w.z;
    if (!(weight > 0.0f)) continue;
    const Slot* slot = find(key_of(base, at + step));
    if (!slot) continue;
    result.sum += weight * slot->light;
    result.weight += weight;
  }
  return result;
}

Vec4f LightCache::look_up(const LightPlace& place) const {
  // A plane runs through half of the corners' weight at least.
  constexpr float kWhole = 0.5f;
  Vec3f sum(0.0f);
  float rest = 1.0f;
  for (int level = 0; level < kLevels; ++level) {
    const int exponent = exponent_of(place.size, level);
    const Interpolated known =
        interpolate(place.position, base_key(place.thing, part_at(place.part, level), exponent), exponent);
    if (!(known.weight > 0.0f)) continue;
    const float share = level + 1 < kLevels ? rest * std::min(1.0f, known.weight / kWhole) : rest;
    sum += share / known.weight * known.sum;
    rest -= share;
    if (!(rest > 1e-3f)) break;
  }
  const float known = 1.0f - rest;
  return known > 0.0f ? Vec4f(sum / known, known) : Vec4f(0.0f);
}

float LightCache::samples(const LightPlace& place) const {
  const int exponent = exponent_of(place.size, 0);
  const Cell* cell = cell_of(
      key_of(base_key(place.thing, part_at(place.part, 0), exponent), cell_at(place.position * std::ldexp(1.0f, -exponent))));
  return cell ? cell->past.count + cell->now.count : 0.0f;
}

float LightCache::share_of_past(const LightPlace& place) const {
  for (int level = 0; level < kLevels; ++level) {
    const int exponent = exponent_of(place.size, level);
    const Cell* cell = cell_of(key_of(base_key(place.thing, part_at(place.part, level), exponent),
                                      cell_at(place.position * std::ldexp(1.0f, -exponent))));
    if (cell) return cell->past.count / std::max(cell->past.count + cell->now.count, 1e-6f);
  }
  return 0.0f;
}

std::size_t LightCache::cells() const {
  std::size_t count = 0;
  for (const Shard& shard : shards_) count += shard.cells.size();
  return count;
}

std::size_t LightCache::bytes() const {
  std::size_t count = 0;
  for (const Shard& shard : shards_) count += shard.cells.capacity() * sizeof(Cell) + shard.slots.capacity() * sizeof(Slot);
  return count;
}

/// Vectors may be twice as large as what they hold, and tables are between a third and a sixth full.
std::size_t LightCache::bytes_per_cell() { return 2 * sizeof(Cell) + 6 * sizeof(Slot); }

}  // namespace lippmann
