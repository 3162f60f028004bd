#include "radiance/radiance_cache.hpp"

#include <bit>
#include <cmath>

#include "radiance/cell_keys.hpp"
#include "transport/bsdf.hpp"
#include "transport/sampling.hpp"

namespace lippmann {
namespace {

/// The keys of the queries' cells of a level, for places moved along the surface, by `reach` times half a cell at most.
LIPPMANN_MULTIVERSION void find_keys(const CacheQueries& q, int level, float reach, std::uint64_t* keys) {
  LIPPMANN_FOR_LANES(i) {
    const int exponent = exponent_of(q.size[i], level);
    const float edge = power_of_two(exponent), scale = power_of_two(-exponent), origin = origin_in_cell(exponent);
    const Frame frame(q.normal.get(i));
    const float x = reach * edge * (q.u[i] - 0.5f), y = reach * edge * (q.v[i] - 0.5f);
    const std::int64_t at_x = whole_cell((q.position.x[i] + (x * frame.x.x + y * frame.y.x)) * scale + origin);
    const std::int64_t at_y = whole_cell((q.position.y[i] + (x * frame.x.y + y * frame.y.y)) * scale + origin);
    const std::int64_t at_z = whole_cell((q.position.z[i] + (x * frame.x.z + y * frame.y.z)) * scale + origin);
    keys[i] = key_of(base_key(q.thing[i], part_at(q.part[i], level), exponent), static_cast<std::uint64_t>(at_x),
                     static_cast<std::uint64_t>(at_y), static_cast<std::uint64_t>(at_z));
  }
}

}  // namespace

const RadianceCache::Slot* RadianceCache::Shard::find(std::uint64_t key) const {
  if (slots.empty()) return nullptr;
  const std::size_t mask = slots.size() - 1;
  for (std::size_t i = key & mask;; i = (i + 1) & mask) {
    if (slots[i].key == key) return &slots[i];
    if (slots[i].key == 0) return nullptr;
  }
}

void RadianceCache::Shard::put(const Slot& slot) {
  const std::size_t mask = slots.size() - 1;
  std::size_t i = slot.key & mask;
  while (slots[i].key != 0) i = (i + 1) & mask;
  slots[i] = slot;
}

void RadianceCache::Shard::reserve(std::size_t wanted) {
  if (2 * wanted <= slots.size()) return;
  std::vector<Slot> old(std::bit_ceil(std::max<std::size_t>(64, 3 * wanted)));
  old.swap(slots);
  for (const Slot& slot : old)
    if (slot.key != 0) put(slot);
}

/// Null where the cell is not known and there is no room for it.
RadianceCache::Cell* RadianceCache::Shard::find_or_add(std::uint64_t key, std::size_t most_cells, bool& is_new) {
  const Slot* slot = find(key);
  is_new = slot == nullptr;
  if (slot) return &cells[slot->cell];
  if (cells.size() >= most_cells) return nullptr;
  reserve(cells.size() + 1);
  Slot added;
  added.key = key, added.cell = static_cast<std::uint32_t>(cells.size()) & kMostCells;
  put(added);
  return &cells.emplace_back();
}

RadianceCache::RadianceCache(std::size_t most_cells)
    : shards_(kShards), most_cells_(std::min<std::size_t>((most_cells + kShards - 1) / kShards, kMostCells)) {}

void RadianceCache::prefetch(std::uint64_t key) const { shards_[shard_of(key)].prefetch(key); }

const RadianceCache::Slot* RadianceCache::find(std::uint64_t key) const { return shards_[shard_of(key)].find(key); }

const RadianceCache::Cell* RadianceCache::cell_of(std::uint64_t key) const {
  const Slot* slot = find(key);
  return slot ? &shards_[shard_of(key)].cells[slot->cell] : nullptr;
}

/// A cell around another knows at least what that knows, unless it belongs to places that are seen from farther away.
std::uint32_t RadianceCache::find_parent(const Cell& cell) const {
  const glm::i64vec3 at = cell_at(cell.center, cell.exponent + 1);
  for (const std::uint32_t part : {cell.part, kAllParts}) {
    const std::uint64_t key = key_of(base_key(cell.thing, part, cell.exponent + 1), at);
    const Slot* slot = find(key);
    if (slot && shards_[shard_of(key)].cells[slot->cell].samples_ever >= cell.samples_ever)
      return static_cast<std::uint32_t>(kShards * slot->cell + shard_of(key));
  }
  return kNothing;
}

/// Statistics ask for a cell's parent a dozen times between records.
void RadianceCache::link_parents(const ThreadPool& pool) {
  if (std::exchange(are_linked_, true)) return;
  constexpr std::size_t kAhead = 8;
  pool.for_each(kShards, [&](std::size_t s) {
    std::vector<Cell>& cells = shards_[s].cells;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (c + kAhead < cells.size()) {
        const Cell& next = cells[c + kAhead];
        prefetch(key_of(base_key(next.thing, next.part, next.exponent + 1), cell_at(next.center, next.exponent + 1)));
      }
      cells[c].around = find_parent(cells[c]);
    }
  });
}

/// A record's cell of one size, or of a thing near by.
struct RadianceCache::Target {
  std::uint64_t key;
  std::uint32_t record, thing;
  std::uint32_t level;
};

/// What one thread found of some records: where they go, by shard.
struct RadianceCache::Targets {
  std::vector<Sample> samples;  ///< by record
  std::array<std::vector<Target>, kShards> of_shard;
};

void RadianceCache::find_targets(std::span<const RadianceRecord> records, Targets& targets) {
  targets.samples.reserve(records.size());
  for (std::uint32_t r = 0; r < records.size(); ++r) {
    const RadianceRecord& record = records[r];
    const CachePoint& place = record.place;
    // Products of sound numbers may overflow on a path: one such would be seen wherever its cells are.
    if (!std::isfinite(targets.samples.emplace_back(record.light).luminance)) continue;
    for (int level = 0; level < kLevels; ++level) {
      const int exponent = exponent_of(place.size, level);
      const glm::i64vec3 at = cell_at(place.position, exponent);
      const auto add_to = [&](std::uint32_t thing) {
        const std::uint64_t key = key_of(base_key(thing, part_at(place.part, level), exponent), at);
        targets.of_shard[shard_of(key)].push_back({key, r, thing, static_cast<std::uint32_t>(level)});
      };
      add_to(place.thing);
      for (const std::uint32_t thing : record.also)
        if (thing != 0) add_to(thing);
    }
  }
}

void RadianceCache::add_to_cell(Cell& cell, const Sample& sample, const RadianceRecord& record) {
  cell.now.add(sample);
  cell.samples_ever += 1.0f;
  const float share = 1.0f / cell.now.count;
  cell.possible_change_now.light += share * (record.changed_light - cell.possible_change_now.light);
  cell.possible_change_now.share += share * (record.changed_share - cell.possible_change_now.share);
  if (record.deepest >= 0.0f) cell.told += sample.luminance, cell.deepest += record.deepest;
}

void RadianceCache::add(std::span<const std::span<const RadianceRecord>> records, const ThreadPool& pool) {
  are_linked_ = false;
  std::vector<Targets> targets(records.size());
  pool.for_each(records.size(), [&](std::size_t piece) { find_targets(records[piece], targets[piece]); });
  pool.for_each(kShards, [&](std::size_t s) {
    for (std::size_t piece = 0; piece < records.size(); ++piece)
      add_to_shard(shards_[s], targets[piece].of_shard[s], targets[piece].samples, records[piece]);
  });
}

/// Slots, cells and records lie anywhere in memory, which is asked for them ahead.
void RadianceCache::add_to_shard(Shard& shard, std::span<const Target> targets, std::span<const Sample> samples,
                                 std::span<const RadianceRecord> records) {
  constexpr std::size_t kCellsAhead = 8, kSlotsAhead = 2 * kCellsAhead;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    if (t + kSlotsAhead < targets.size()) {
      const Target& next = targets[t + kSlotsAhead];
      shard.prefetch(next.key);
      __builtin_prefetch(&samples[next.record]);
      __builtin_prefetch(&records[next.record].changed_light);
    }
    if (t + kCellsAhead < targets.size()) {
      if (const Slot* const slot = shard.find(targets[t + kCellsAhead].key)) __builtin_prefetch(&shard.cells[slot->cell].now);
    }
    const Target& target = targets[t];
    bool is_new = false;
    Cell* const cell = shard.find_or_add(target.key, most_cells_, is_new);
    if (!cell) continue;
    if (is_new) {
      const CachePoint& place = records[target.record].place;
      const int level = static_cast<int>(target.level);
      cell->thing = target.thing;
      cell->part = part_at(place.part, level);
      cell->exponent = exponent_of(place.size, level);
      cell->center = center_of_cell(cell_at(place.position, cell->exponent), cell->exponent);
    }
    add_to_cell(*cell, samples[target.record], records[target.record]);
  }
}

/// Looks up the lanes of `left`: those whose cells there are leave it.
void RadianceCache::find_all(const std::uint64_t* keys, EdgesToPaths edges, LookedUp what, LaneMask& left, LaneMask& known,
                             Lanes3& light) const {
  for (int i = 0; i < kLanes; ++i)
    if (left.lane[i]) prefetch(keys[i]);
  for (int i = 0; i < kLanes; ++i) {
    if (!left.lane[i]) continue;
    const Slot* slot = find(keys[i]);
    if (!slot || !slot->is_resolved) continue;
    left.lane[i] = 0;
    if (slot->is_in(edges) || (what == LookedUp::kWithoutDeepest && !slot->ends_paths)) continue;
    light.set(i, what == LookedUp::kAll ? slot->light : (1.0f - slot->deepest_share) * slot->light);
    known.lane[i] = -1;
  }
}

LaneMask RadianceCache::pick(const CacheQueries& queries, EdgesToPaths edges, LookedUp what, Lanes3& light) const {
  LaneMask left = queries.active, known{};
  alignas(64) std::uint64_t keys[kLanes];
  for (int level = 0; level < kLevels; ++level) {
    // Somewhere within half a cell; at its rim there may be none, and the cell around the place itself serves.
    for (const float reach : {1.0f, 0.0f}) {
      find_keys(queries, level, reach, keys);
      find_all(keys, edges, what, left, known, light);
      if (!any(left)) return known;
    }
  }
  return known;
}

RadianceCache::Interpolated RadianceCache::interpolate(Vec3f p, std::uint64_t base, int exponent) const {
  const Vec3f q = in_cells(p, exponent) - 0.5f;
  const Vec3f lower = glm::floor(q), f = q - lower;
  const glm::i64vec3 at = whole_cell(q);
  Interpolated result;
  constexpr std::size_t kCorners = 8;
  std::array<std::uint64_t, kCorners> keys;
  const auto step_to = [](std::size_t corner) { return glm::i64vec3(corner & 1u, corner >> 1u & 1u, corner >> 2u); };
  for (std::size_t corner = 0; corner < kCorners; ++corner) prefetch(keys[corner] = key_of(base, at + step_to(corner)));
  for (std::size_t corner = 0; corner < kCorners; ++corner) {
    const glm::i64vec3 step = step_to(corner);
    const Vec3f w(step.x ? f.x : 1.0f - f.x, step.y ? f.y : 1.0f - f.y, step.z ? f.z : 1.0f - f.z);
    const float weight = w.x * w.y * w.z;
    if (!(weight > 0.0f)) continue;
    const Slot* slot = find(keys[corner]);
    if (!slot || !slot->is_resolved) continue;
    result.sum += weight * slot->light;
    result.weight += weight;
  }
  return result;
}

Vec4f RadianceCache::look_up(const CachePoint& place) const {
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

float RadianceCache::samples(const CachePoint& place) const {
  const int exponent = exponent_of(place.size, 0);
  const Cell* cell =
      cell_of(key_of(base_key(place.thing, part_at(place.part, 0), exponent), cell_at(place.position, exponent)));
  return cell ? cell->past.count + cell->now.count : 0.0f;
}

float RadianceCache::share_of_past(const CachePoint& place) const {
  for (int level = 0; level < kLevels; ++level) {
    const int exponent = exponent_of(place.size, level);
    const Cell* cell =
        cell_of(key_of(base_key(place.thing, part_at(place.part, level), exponent), cell_at(place.position, exponent)));
    if (cell) return cell->past.count / std::max(cell->past.count + cell->now.count, 1e-6f);
  }
  return 0.0f;
}

std::size_t RadianceCache::cells() const {
  std::size_t count = 0;
  for (const Shard& shard : shards_) count += shard.cells.size();
  return count;
}

std::size_t RadianceCache::bytes() const {
  std::size_t count = 0;
  for (const Shard& shard : shards_) count += shard.cells.capacity() * sizeof(Cell) + shard.slots.capacity() * sizeof(Slot);
  return count;
}

/// Vectors may be twice as large as what they hold, and tables are between a third and a sixth full.
std::size_t RadianceCache::bytes_per_cell() { return 2 * sizeof(Cell) + 6 * sizeof(Slot); }

}  // namespace lippmann
