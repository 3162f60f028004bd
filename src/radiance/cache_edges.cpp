// Where light changes too abruptly for the radiance cache's cells: the rims of caustics, and sharp shadows of what the cache
// holds. Cells blur them over their own width, which means over pixels and lenses show, so places there may get paths of their
// own.
//
// Light that changes evenly is interpolated without error; what is left is its second difference, from a cell to those on both
// sides of it. That of a step is the step itself at every size of cells, and larger cells are the more certain of it: where one
// of them is at an edge, cells within it are that bend at all.
#include <cmath>

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

/// The strongest of the 13 directions in which there are neighbours on both sides.
RadianceCache::Bend RadianceCache::bend(const Cell& cell) const {
  constexpr int kCube = 27;  // one cell, in the middle, and those around it
  if (cell.samples < kLeastSamples) return {};
  const glm::i64vec3 at = cell_at(cell.center, cell.exponent);
  const std::uint64_t base = base_key(cell.thing, cell.part, cell.exponent);
  const auto neighbour = [&](glm::i64vec3 step) {
    const Cell* const found = cell_of(key_of(base, at + step));
    return found && found->samples >= kLeastSamples ? found : nullptr;
  };
  Bend most;
  for (int n = kCube / 2 + 1; n < kCube; ++n) {
    const glm::i64vec3 step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    const Cell* const after = neighbour(step);
    const Cell* const before = after ? neighbour(-step) : nullptr;
    if (!before) continue;
    const Bend along = bend(cell, *before, *after);
    most.seen = stronger(most.seen, along.seen), most.sure = stronger(most.sure, along.sure);
  }
  return most;
}

void RadianceCache::find_edges(const SlotsBySize& by_size, const ThreadPool& pool) {
  for (const auto& [exponent, slots] : by_size)
    for_each_of_size(pool, slots, [this](Cell& cell, Slot&) { cell.bend = bend(cell); });
  for (const auto& [exponent, slots] : by_size)
    for_each_of_size(pool, slots, [this](Cell& cell, Slot&) {
      const Cell* const parent = cell.bend.seen == EdgesToPaths::kNone ? nullptr : parent_of(cell);
      cell.edge = stronger(cell.bend.sure, parent ? weaker(cell.bend.seen, parent->bend.sure) : EdgesToPaths::kNone);
    });
  // Now that no slot is looked for any more.
  for (const auto& [exponent, slots] : by_size)
    for_each_of_size(pool, slots, [](const Cell& cell, Slot& slot) { slot.edge = static_cast<std::uint32_t>(cell.edge) & 3u; });
}

}  // namespace lippmann
