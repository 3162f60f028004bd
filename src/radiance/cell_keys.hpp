// Names of the radiance cache's cells: where they lie, how large they are and of which thing, hashed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "device/fast_math.hpp"
#include "device/lanes.hpp"
#include "lippmann/core/math.hpp"

namespace lippmann {

/// Cells from this level on hold all parts of a thing.
inline constexpr int kJointLevel = 2;
inline constexpr std::uint32_t kAllParts = 0xFFFFFFFFu;

LIPPMANN_INLINE std::uint64_t mixed_bits(std::uint64_t x) {  // Stafford's mix 13
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

LIPPMANN_INLINE int exponent_of(float size, int level) {
  // What is not a number, too, ends at the least.
  return floor_log2(size > 1e-30f ? std::min(size, 1e30f) : 1e-30f) + level;
}

LIPPMANN_INLINE std::uint32_t part_at(std::uint32_t part, int level) { return level < kJointLevel ? part : kAllParts; }

LIPPMANN_INLINE std::uint64_t base_key(std::uint32_t thing, std::uint32_t part, int exponent) {
  return mixed_bits((static_cast<std::uint64_t>(thing) << 32 | part) + mixed_bits(static_cast<std::uint64_t>(exponent + 1024)));
}

LIPPMANN_INLINE std::uint64_t key_of(std::uint64_t base, std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return mixed_bits(base + x * 0x9e3779b97f4a7c15ull + y * 0xc2b2ae3d27d4eb4full + z * 0x165667b19e3779f9ull) | 1u;
}

inline std::uint64_t key_of(std::uint64_t base, glm::i64vec3 at) {
  return key_of(base, static_cast<std::uint64_t>(at.x), static_cast<std::uint64_t>(at.y), static_cast<std::uint64_t>(at.z));
}

inline std::size_t shard_of(std::uint64_t key) { return key >> 58; }

/// Cells are 2^exponent wide, and the origin lies a third (of even exponents) or two thirds of a cell above a border: people
/// put floors and walls at 0 and at round numbers, and were these borders, rounding would share every plane's light out among
/// the cells on both sides. A cell twice as wide still holds whole ones: 2 * 2/3 - 1/3 and 2 * 1/3 - 2/3 are whole numbers.
LIPPMANN_INLINE float origin_in_cell(int exponent) { return (exponent & 1) ? 2.0f / 3.0f : 1.0f / 3.0f; }

/// Far beyond any scene's cells coordinates have no digits left for them: they all end in one.
LIPPMANN_INLINE std::int64_t whole_cell(float p) {
  return static_cast<std::int64_t>(std::min(std::max(std::floor(p), -1e15f), 1e15f));
}

inline glm::i64vec3 whole_cell(Vec3f p) { return {whole_cell(p.x), whole_cell(p.y), whole_cell(p.z)}; }

/// In cells, from the border of the one numbered 0.
inline Vec3f in_cells(Vec3f p, int exponent) { return p * std::ldexp(1.0f, -exponent) + origin_in_cell(exponent); }

inline glm::i64vec3 cell_at(Vec3f p, int exponent) { return whole_cell(in_cells(p, exponent)); }

inline Vec3f center_of_cell(glm::i64vec3 at, int exponent) {
  return (Vec3f(at) + (0.5f - origin_in_cell(exponent))) * std::ldexp(1.0f, exponent);
}

}  // namespace lippmann
