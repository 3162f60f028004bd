// What the radiance cache makes of its samples: how far cells are drawn to larger ones (empirical Bayes, with an analysis of
// variance), and what the past is worth in a new frame.
//
// How uncertain a cell is follows from how many samples it has and from how much samples scatter in all the cells around it,
// not from its own: of two neighbours the one that a rare bright sample has fallen into would seem the less certain and would
// be drawn to the other, and light be lost. Samples scatter in proportion to how bright it is, which the mean fourth root of
// the luminance tells almost regardless of rare bright samples.
#include <array>
#include <cmath>

#include "radiance/radiance_cache.hpp"
#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

/// A history counts as this many samples at most: what drifts too slowly to be noticed is forgotten in the end.
constexpr float kLongestHistory = 2048.0f;
/// Means that differ by more than this many deviations do not differ by chance.
constexpr float kContradiction = 3.0f;
/// Few samples say little of how much they scatter, and of what may have changed: the larger cell around counts as so many.
constexpr float kPrior = 8.0f;
/// Where all of few samples were dark, a cell is not sure to be black: how bright the larger one is counts as so many.
constexpr float kPriorLevel = 16.0f;
/// What a larger cell says of how much cells differ counts as so many of them at most (prior_cells()), found by trial.
constexpr float kMostPriorCells = 16.0f;
/// Samples scatter alike in proportion to the light: the larger cell around says more of it than a cell's own samples, of which
/// a single one may be all.
constexpr float kPriorScatter = 200.0f;
/// Paths of updates end in cells of so many samples: what one is wrong about, all cells that it shines on are. Found by trial.
constexpr float kEndsPaths = 4.0f;
/// Light that is none, squared.
constexpr float kNone = 1e-20f;
/// So much of the light along rays that pass what moves, or that arrive at another angle, changes from frame to frame: most of
/// them meet the same thing again, and others make up for those.
constexpr float kChanging = 0.5f;

/// How many cells it counts as, what the cell around a larger one says of how much the cells within that larger one differ: as
/// many as make it as certain as they themselves are. The latter are few, and one that is far off by bad luck would seem to
/// know better. By how much chance alone makes them differ, over what is expected: `chance`. What is expected may be wrong by
/// twice itself.
float prior_cells(float chance) { return std::min(0.5f * squared(1.0f + chance), kMostPriorCells); }

float fourth_root(float x) { return std::sqrt(std::sqrt(std::max(x, 0.0f))); }

}  // namespace

RadianceCache::Sample::Sample(Vec3f arrived)
    : light(arrived), luminance(lippmann::luminance(arrived)), root(fourth_root(luminance)) {}

void RadianceCache::Moments::add(const Sample& sample) {
  count += 1.0f;
  const float share = 1.0f / count;
  mean += share * (sample.light - mean);
  square += share * (squared(sample.luminance) - square);
  root += share * (sample.root - root);
  root_square += share * (squared(sample.root) - root_square);
}

void RadianceCache::Moments::add(const Moments& more) {
  if (!(more.count > 0.0f)) return;
  count += more.count;
  const float share = more.count / count;
  mean += share * (more.mean - mean);
  square += share * (more.square - square);
  root += share * (more.root - root);
  root_square += share * (more.root_square - root_square);
}

float RadianceCache::Moments::variance() const { return std::max(0.0f, square - squared(luminance(mean))); }

float RadianceCache::Moments::root_variance() const { return std::max(0.0f, root_square - squared(root)); }

RadianceCache::PlacesBySize RadianceCache::places_by_size(const ThreadPool& pool) const {
  std::array<std::map<int, std::vector<Place>>, kShards> of_shard;
  pool.for_each(kShards, [&](std::size_t s) {
    const Shard& shard = shards_[s];
    std::vector<std::uint32_t> slot_of(shard.cells.size());
    for (std::uint32_t i = 0; i < shard.slots.size(); ++i)
      if (shard.slots[i].key != 0) slot_of[shard.slots[i].cell] = i;
    for (std::uint32_t c = 0; c < slot_of.size(); ++c) of_shard[s][shard.cells[c].exponent].push_back({c, slot_of[c]});
  });
  PlacesBySize all;
  for (std::size_t s = 0; s < kShards; ++s)
    for (auto& [exponent, places] : of_shard[s]) all[exponent][s] = std::move(places);
  return all;
}

/// What the past is still worth, 0 ... 1, where it and the records of this frame differ by more than chance explains.
float RadianceCache::contradicted(const Cell& cell) {
  if (!(cell.now.count > 0.0f && cell.inherited > 0.0f)) return 1.0f;
  const float change = squared(cell.now.root - cell.past.root);
  const float by_chance = cell.scatter.root * (1.0f / cell.now.count + 1.0f / cell.inherited);
  if (!(change > squared(kContradiction) * by_chance)) return 1.0f;
  // So many samples are as uncertain as the past is wrong.
  return std::min(1.0f, cell.scatter.root / (change - by_chance) / cell.inherited);
}

/// The same, where what moves may have changed the light: its variance grows by the square of what may have changed, as that of
/// a Kalman filter's state does. How bright it is and how much samples scatter, the cell around tells: by their own samples,
/// cells that were lucky would keep more of their past than those that were not, or less, and light would be gained or lost.
float RadianceCache::possibly_changed(const Cell& cell, const Cell* parent) {
  const Cell& around = parent ? *parent : cell;
  const float light = std::max(luminance(around.past.mean), luminance(around.now.mean));
  const float change = squared(std::abs(cell.possible_change.light) + kChanging * cell.possible_change.share * light);
  return change > 0.0f ? around.scatter.light / (around.scatter.light + cell.inherited * change) : 1.0f;
}

/// And where a cell has moved: light is taken to change as it does from cell to cell, whose centres are half a cell from their
/// parent's.
float RadianceCache::outdated(const Cell& cell, const Cell& parent, float moved) {
  const float cells = std::min(1.0f, std::ldexp(moved, -cell.exponent));
  const float change = 4.0f * parent.relief * squared(cells), count = cell.past.count + cell.now.count;
  return change > 0.0f ? cell.scatter.light / (cell.scatter.light + count * change) : 1.0f;
}

void RadianceCache::begin_frame(const Motion& moved, const ThreadPool& pool) {
  link_parents(pool);
  for (const auto& [exponent, places] : places_by_size(pool))
    for_each_of_size(pool, places, [&](Cell& cell, Slot&) {
      const Cell* parent = parent_of(cell);
      cell.keep = parent ? std::min(parent->keep, outdated(cell, *parent, moved(cell.thing, cell.center))) : 1.0f;
    });
  pool.for_each(kShards, [&](std::size_t s) {
    for (Cell& cell : shards_[s].cells) {
      cell.past.add(cell.now);
      cell.past.count = cell.inherited = std::min(cell.past.count * cell.keep, kLongestHistory);
      cell.now = {};
      cell.possible_change_now = {};
    }
  });
}

float RadianceCache::forget(const ThreadPool& pool) {
  link_parents(pool);
  for (const auto& [exponent, places] : places_by_size(pool))
    for_each_of_size(pool, places, [&](Cell& cell, Slot&) {
      const Cell* parent = parent_of(cell);
      const float own = parent ? cell.now.count / (cell.now.count + kPrior) : 1.0f;
      const PossibleChange around = parent ? parent->possible_change : PossibleChange{};
      cell.possible_change = {glm::mix(around.light, cell.possible_change_now.light, own),
                              glm::mix(around.share, cell.possible_change_now.share, own)};
      cell.keep = std::min(parent ? parent->keep : 1.0f, contradicted(cell));
      cell.past.count = cell.inherited * std::min(cell.keep, possibly_changed(cell, parent));
    });
  std::array<double, kShards> known{}, kept{};
  pool.for_each(kShards, [&](std::size_t s) {
    for (const Cell& cell : shards_[s].cells)
      known[s] += static_cast<double>(cell.inherited), kept[s] += static_cast<double>(cell.past.count);
  });
  double all = 0.0, left = 0.0;
  for (std::size_t s = 0; s < kShards; ++s) all += known[s], left += kept[s];
  return all > 0.0 ? static_cast<float>(1.0 - left / all) : 0.0f;
}

/// use(parent, sums of of_cell(cell, slot) over the cells of a size within it), with as many numbers as of_cell gives; in the
/// order of cells, whatever the threads.
void RadianceCache::sum_into_parents(const PlacesOfShards& places, const PlacesOfShards& parents, const ThreadPool& pool,
                                     const auto& of_cell, const auto& use) {
  using Sums = decltype(of_cell(std::declval<const Cell&>(), std::declval<const Slot&>(), std::declval<const Cell&>()));
  struct Part {
    std::uint32_t parent;
    Sums values;
  };
  std::vector<std::array<std::vector<Part>, kShards>> parts(kShards);
  pool.for_each(kShards, [&](std::size_t s) {
    for_each_in(s, places, [&](const Cell& cell, const Slot& slot) {
      if (const Cell* parent = parent_of(cell))
        parts[s][cell.around % kShards].push_back(
            {cell.around / static_cast<std::uint32_t>(kShards), of_cell(cell, slot, *parent)});
    });
  });
  pool.for_each(kShards, [&](std::size_t s) {
    std::vector<Sums> sums(shards_[s].cells.size(), Sums{});
    for (std::size_t from = 0; from < kShards; ++from)
      for (const Part& part : parts[from][s])
        for (std::size_t v = 0; v < part.values.size(); ++v) sums[part.parent][v] += part.values[v];
    for (const Place& place : parents[s]) use(shards_[s].cells[place.cell], sums[place.cell]);
  });
}

/// How bright it is, as what samples scatter is in proportion to: between the cell's own light and that of the cell around it,
/// as a dark cell among brighter ones may have missed something, and a bright one may have been lucky.
float RadianceCache::level(const Cell& cell, const Cell* parent) {
  return squared(cell.root) * squared(parent ? parent->root : cell.root);
}

/// The share of light that was scattered as often as paths may be: few records are told apart from none of that by the larger
/// cell.
float RadianceCache::deepest_share(const Cell& cell, const Cell* parent) {
  const float prior = parent ? kPriorLevel * cell.luminance : 0.0f, all = cell.told + prior;
  const float deepest = cell.deepest + (parent ? prior * parent->deepest_share : 0.0f);
  return all > 0.0f ? std::min(deepest / all, 1.0f) : 0.0f;
}

/// Means of the cells of a size, and how much their samples scatter: as those of all cells within the same larger one.
void RadianceCache::find_scatter(const PlacesOfShards& places, const PlacesOfShards* wider, const ThreadPool& pool) {
  for_each_of_size(pool, places, [&](Cell& cell, Slot& slot) {
    Moments all = cell.past;
    all.add(cell.now);
    cell.samples = all.count;
    cell.luminance = luminance(all.mean);
    const Cell* parent = parent_of(cell);
    cell.root = parent ? (all.count * all.root + kPriorLevel * parent->root) / (all.count + kPriorLevel) : all.root;
    cell.scatter = {all.variance(), all.root_variance()};
    slot.light = cell.own = all.mean;
    cell.deepest_share = slot.deepest_share = deepest_share(cell, parent);
    slot.is_resolved = 1, slot.ends_paths = cell.samples >= kEndsPaths;
    cell.drawn = 0.0f, cell.shift = Vec3f(0.0f);
  });
  if (wider) {
    sum_into_parents(
        places, *wider, pool,
        [](const Cell& cell, const Slot&, const Cell& parent) {
          const float freedom = std::max(0.0f, cell.samples - 1.0f), level = RadianceCache::level(cell, &parent);
          return std::array{cell.samples * cell.scatter.light, cell.samples * cell.scatter.root, freedom * squared(level),
                            freedom * std::sqrt(level)};
        },
        [](Cell& parent, const std::array<float, 4>& sums) {
          const float level = squared(squared(parent.root));
          const Scatter weight{kPriorScatter * squared(level) + kNone, kPriorScatter * std::sqrt(level) + kNone};
          parent.within = {(sums[0] + weight.light * parent.relative.light) / (sums[2] + weight.light),
                           (sums[1] + weight.root * parent.relative.root) / (sums[3] + weight.root)};
        });
  }
  for_each_of_size(pool, places, [&](Cell& cell, Slot&) {
    const Cell* parent = parent_of(cell);
    const float of = level(cell, parent);
    if (parent) {
      cell.relative = parent->within;
      cell.scatter = {cell.relative.light * squared(of), cell.relative.root * std::sqrt(of)};
    } else {
      cell.relative = {cell.scatter.light / (squared(of) + kNone), cell.scatter.root / (std::sqrt(of) + kNone)};
    }
    cell.variance = cell.scatter.light / std::max(cell.samples, 1e-6f);
  });
}

void RadianceCache::compare_with_wider(Cell& cell) const {
  cell.has_wider = false;
  const Cell* parent = parent_of(cell);
  if (!parent) return;
  const Vec4f around = look_up({cell.center, cell.thing, parent->part, std::ldexp(1.0f, cell.exponent + 1)});
  cell.has_wider = around.w > 0.0f;
  cell.wider = Vec3f(around);
}

/// By what the cells of a size differ from what larger ones say of them, beyond what chance explains (analysis of variance):
/// the spread of the larger ones.
void RadianceCache::find_spreads(const PlacesOfShards& places, const PlacesOfShards& wider, const ThreadPool& pool) {
  sum_into_parents(
      places, wider, pool,
      [](const Cell& cell, const Slot& slot, const Cell& parent) {
        if (!cell.has_wider) return std::array<float, 5>{};
        const float share = std::min(1.0f, cell.samples / std::max(parent.samples, 1.0f));
        return std::array{cell.samples * squared(luminance(slot.light) - luminance(cell.wider)),
                          cell.samples * squared(cell.luminance - parent.luminance), cell.scatter.light * (1.0f - share),
                          cell.samples, 1.0f};
      },
      [this](Cell& parent, const std::array<float, 5>& sums) {
        const auto [squares, from_mean, chance, count, cells] = sums;
        const float found = count > 0.0f ? std::max(0.0f, squares - chance) / count : 0.0f;
        parent.relief = count > 0.0f ? std::max(0.0f, from_mean - chance) / count : 0.0f;
        const Cell* wider_still = parent_of(parent);
        // Light that changes evenly differs a quarter as much over half the distance.
        const float expected = wider_still ? 0.25f * wider_still->spread : found;
        const float of_cells = prior_cells(chance / std::max(count * expected, kNone)) * count / std::max(cells, 1.0f);
        const float prior = std::max(kPrior, of_cells);
        parent.spread = (count * found + prior * expected) / (count + prior);
      });
}

/// Draws the cell's own mean towards what is around it, as far as both are as uncertain (empirical Bayes).
void RadianceCache::resolve(Cell& cell, Slot& slot) const {
  if (!cell.has_wider) return;
  const Cell* parent = parent_of(cell);
  const float spread = parent->spread + parent->variance;
  // What is left of a forgotten past, less than a sample, knows nothing by itself.
  const float known = std::min(1.0f, cell.samples) * spread / std::max(cell.variance + spread, 1e-30f), a = 1.0f - known;
  slot.light += a * (cell.wider - slot.light);
  cell.variance *= 1.0f - a;
  cell.drawn = a;
}

/// Cells that are drawn to what is around them must lose no light together: on average they are drawn as the cell around them
/// was, and what they have lost beyond that they are given back, each as far as it was drawn.
void RadianceCache::balance(const PlacesOfShards& places, const PlacesOfShards& wider, const ThreadPool& pool) {
  sum_into_parents(
      places, wider, pool,
      [](const Cell& cell, const Slot& slot, const Cell&) {
        const Vec3f taken = cell.samples * (slot.light - cell.own);
        return std::array{taken.x, taken.y, taken.z, cell.samples * cell.drawn};
      },
      [](Cell& parent, const std::array<float, 4>& sums) {
        // What less than a sample has lost is worth nothing.
        parent.balance = (sums[3] * parent.shift - Vec3f(sums[0], sums[1], sums[2])) / (sums[3] + 1.0f);
      });
  for_each_of_size(pool, places, [&](Cell& cell, Slot& slot) {
    if (const Cell* parent = parent_of(cell)) slot.light = glm::max(slot.light + cell.drawn * parent->balance, Vec3f(0.0f));
    cell.shift = slot.light - cell.own;
  });
}

void RadianceCache::resolve(const ThreadPool& pool) {
  is_resolved_ = true;
  link_parents(pool);
  const PlacesBySize by_size = places_by_size(pool);
  for (const auto& [exponent, places] : by_size) {
    const auto wider = by_size.find(exponent + 1);
    const PlacesOfShards* parents = wider != by_size.end() ? &wider->second : nullptr;
    find_scatter(places, parents, pool);
    for_each_of_size(pool, places, [&](Cell& cell, Slot&) { compare_with_wider(cell); });
    if (parents) find_spreads(places, *parents, pool);
    for_each_of_size(pool, places, [&](Cell& cell, Slot& slot) { resolve(cell, slot); });
    if (parents) balance(places, *parents, pool);
  }
  find_edges(by_size, pool);
}

}  // namespace lippmann
