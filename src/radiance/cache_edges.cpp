// Where light changes too abruptly for the radiance cache's cells: the rims of caustics, and sharp shadows of what the cache
// holds. Cells blur them over their own width, which means over pixels and lenses show, so places there may get paths of their
// own.
//
// Light that changes evenly is interpolated without error; what is left is its second difference, from a cell to those on both
// sides of it. That of a step is the step itself at every size of cells, and larger cells are the more certain of it: where one
// of them is at an edge, cells within it are that bend at all.
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "radiance/cell_keys.hpp"
#include "radiance/measured_codes.hpp"
#include "radiance/radiance_cache.hpp"

namespace lippmann {
namespace {

/// The albedo of the surface that shows the light.
constexpr float kAlbedo = 0.7f;
/// Deviations by which a second difference is more than chance explains.
constexpr float kSure = 4.0f;
/// Cells of fewer samples tell nothing.
constexpr float kLeastSamples = 2.0f;

/// Half of the second difference of the light, as codes show it.
EdgesToPaths edges_with(float light, float second_difference) {
  const float codes = code_of(kAlbedo * (light + 0.5f * second_difference)) - code_of(kAlbedo * light);
  if (!(codes > 0.05f)) return EdgesToPaths::kNone;
  if (!(codes > 0.1f)) return EdgesToPaths::kFaint;
  return codes > 0.2f ? EdgesToPaths::kStrong : EdgesToPaths::kVisible;
}

/// Whichever more of the edges have: kNone is weaker than any.
EdgesToPaths stronger(EdgesToPaths a, EdgesToPaths b) {
  if (a == EdgesToPaths::kNone || b == EdgesToPaths::kNone) return std::max(a, b);
  return std::min(a, b);
}
EdgesToPaths weaker(EdgesToPaths a, EdgesToPaths b) {
  if (a == EdgesToPaths::kNone || b == EdgesToPaths::kNone) return EdgesToPaths::kNone;
  return std::max(a, b);
}

}  // namespace

/// From a cell to two of its neighbours, one on each side.
RadianceCache::Bend RadianceCache::bend(const Cell& cell, const Cell& before, const Cell& after) {
  const float difference = std::abs(before.luminance + after.luminance - 2.0f * cell.luminance);
  const float around = 0.25f * (before.luminance + after.luminance + 2.0f * cell.luminance);
  const float chance =
      before.scatter.light / before.samples + after.scatter.light / after.samples + 4.0f * cell.scatter.light / cell.samples;
  const EdgesToPaths seen = edges_with(around, difference);
  return {seen, squared(difference) > squared(kSure) * chance ? seen : EdgesToPaths::kNone};
}

namespace {

/// Directions from a cell to those around it, each with its opposite left out: half of a cube of 27 cells.
constexpr std::size_t kDirections = 13;
/// So many cells' neighbours are looked for at once: memory is slow, but answers many questions at a time.
constexpr std::size_t kBatch = 8;

std::array<glm::i64vec3, kDirections> directions() {
  std::array<glm::i64vec3, kDirections> steps{};
  for (int i = 0; i < static_cast<int>(kDirections); ++i) {
    const int n = static_cast<int>(kDirections) + 1 + i;
    steps[static_cast<std::size_t>(i)] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
  }
  return steps;
}

}  // namespace

/// Cell::bend of kBatch cells at most: the strongest of the directions in which there are neighbours on both sides.
void RadianceCache::find_bends(std::span<Cell* const> cells) const {
  static const std::array<glm::i64vec3, kDirections> kSteps = directions();
  struct Around {
    std::uint64_t after, before;  ///< keys
    const Cell *cell_after, *cell_before;
  };
  std::array<std::array<Around, kDirections>, kBatch> around;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const glm::i64vec3 at = cell_at(cells[c]->center, cells[c]->exponent);
    const std::uint64_t base = base_key(cells[c]->thing, cells[c]->part, cells[c]->exponent);
    for (std::size_t d = 0; d < kDirections; ++d) {
      around[c][d] = {key_of(base, at + kSteps[d]), key_of(base, at - kSteps[d]), nullptr, nullptr};
      for (const std::uint64_t key : {around[c][d].after, around[c][d].before}) prefetch(key);
    }
  }
  const auto neighbour = [&](std::uint64_t key) {
    const Cell* const cell = cell_of(key);
    if (cell) __builtin_prefetch(&cell->samples);
    return cell;
  };
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (Around& one : around[c])
      if ((one.cell_after = neighbour(one.after))) one.cell_before = neighbour(one.before);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Bend most;
    for (const Around& one : around[c]) {
      if (!one.cell_before || one.cell_after->samples < kLeastSamples || one.cell_before->samples < kLeastSamples) continue;
      const Bend along = bend(*cells[c], *one.cell_before, *one.cell_after);
      most.seen = stronger(most.seen, along.seen), most.sure = stronger(most.sure, along.sure);
    }
    cells[c]->bend = most;
  }
}

void RadianceCache::find_edges(const PlacesBySize& by_size, const ThreadPool& pool) {
  pool.for_each(kShards, [&](std::size_t s) {
    std::vector<Cell*> batch;
    const auto find = [&] { find_bends(batch), batch.clear(); };
    for (Cell& cell : shards_[s].cells) {
      cell.bend = {};
      if (cell.samples < kLeastSamples) continue;
      batch.push_back(&cell);
      if (batch.size() == kBatch) find();
    }
    find();
  });
  for (const auto& [exponent, places] : by_size)
    for_each_of_size(pool, places, [this](Cell& cell, Slot&) {
      const Cell* const parent = cell.bend.seen == EdgesToPaths::kNone ? nullptr : parent_of(cell);
      cell.edge = stronger(cell.bend.sure, parent ? weaker(cell.bend.seen, parent->bend.sure) : EdgesToPaths::kNone);
    });
  // Now that no slot is looked for any more.
  for (const auto& [exponent, places] : by_size)
    for_each_of_size(pool, places,
                     [](const Cell& cell, Slot& slot) { slot.edge = static_cast<std::uint32_t>(cell.edge) & 3u; });
}

}  // namespace lippmann
