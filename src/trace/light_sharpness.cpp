// Where light changes too abruptly for the light cache's cells: the rims of caustics, and sharp shadows of what the cache
// holds. Cells blur them over their own width, which means over pixels and lenses show, so places there get paths of their own.
//
// Light that changes evenly is interpolated without error; what is left is its second difference, from a cell to those on both
// sides of it. That of a step is the step itself at every size of cells, and larger cells are the more certain of it: where one
// of them is sharp, cells within it are that bend at all.
#include <cmath>

#include "trace/light_cache.hpp"
#include "trace/light_cell_keys.hpp"
#include "trace/measured_codes.hpp"

namespace lippmann {
namespace {

/// Of sRGB's codes (0 ... 1), on a surface of such an albedo: less of half a second difference is left to the cells.
constexpr float kVisible = 0.05f, kAlbedo = 0.7f;
/// Deviations by which it is more than chance explains.
constexpr float kSharp = 4.0f;
/// Cells of fewer samples are not asked.
constexpr float kLeastSamples = 2.0f;

bool is_visible(float light, float difference) {
  return code_of(kAlbedo * (light + 0.5f * difference)) - code_of(kAlbedo * light) > kVisible;
}

}  // namespace

/// The second difference of the light from a cell to two of its neighbours, one on each side.
LightCache::Bend LightCache::bend(const Cell& cell, const Cell& before, const Cell& after) {
  const float difference = std::abs(before.luminance + after.luminance - 2.0f * cell.luminance);
  const float around = 0.25f * (before.luminance + after.luminance + 2.0f * cell.luminance);
  const float chance =
      before.scatter.light / before.samples + after.scatter.light / after.samples + 4.0f * cell.scatter.light / cell.samples;
  if (!(is_visible(around, difference))) return Bend::kNone;
  return difference * difference > kSharp * kSharp * chance ? Bend::kSharp : Bend::kPerhaps;
}

/// The largest of the 13 directions in which there are neighbours on both sides.
LightCache::Bend LightCache::bend(const Cell& cell) const {
  constexpr int kCube = 27;  // of the cells around one, and itself in the middle
  if (cell.samples < kLeastSamples) return Bend::kNone;
  const glm::i64vec3 at = cell_at(cell.center * std::ldexp(1.0f, -cell.exponent));
  const std::uint64_t base = base_key(cell.thing, cell.part, cell.exponent);
  const auto neighbour = [&](glm::i64vec3 step) {
    const Cell* const found = cell_of(key_of(base, at + step));
    return found && found->samples >= kLeastSamples ? found : nullptr;
  };
  Bend most = Bend::kNone;
  for (int n = kCube / 2 + 1; n < kCube; ++n) {
    const glm::i64vec3 step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    const Cell* const after = neighbour(step);
    const Cell* const before = after ? neighbour(-step) : nullptr;
    if (before) most = std::max(most, bend(cell, *before, *after));
  }
  return most;
}

void LightCache::find_sharp(const SlotsBySize& by_size, const ThreadPool& pool) {
  for (const auto& [exponent, slots] : by_size)
    for_each_of_size(pool, slots, [this](Cell& cell, Slot&) { cell.bend = bend(cell); });
  for (const auto& [exponent, slots] : by_size)
    for_each_of_size(pool, slots, [this](Cell& cell, Slot&) {
      const Cell* const parent = cell.bend == Bend::kPerhaps ? parent_of(cell) : nullptr;
      cell.is_sharp = cell.bend == Bend::kSharp || (parent && parent->bend == Bend::kSharp);
    });
  // Now that no slot is looked for any more.
  for (const auto& [exponent, slots] : by_size)
    for_each_of_size(pool, slots, [](const Cell& cell, Slot& slot) { slot.is_sharp = cell.is_sharp; });
}

}  // namespace lippmann
