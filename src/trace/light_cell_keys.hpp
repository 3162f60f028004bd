// Names of the light cache's cells: where they lie, how large they are and of which thing, hashed. Private to src/trace.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/math.hpp"
#include "trace/fast_math.hpp"
#include "trace/lanes.hpp"

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

/// Far beyond any scene's cells coordinates have no digits left for them: they all end in one.
LIPPMANN_INLINE std::int64_t cell_at(float p) {
  return static_cast<std::int64_t>(std::min(std::max(std::floor(p), -1e15f), 1e15f));
}

inline glm::i64vec3 cell_at(Vec3f p) { return {cell_at(p.x), cell_at(p.y), cell_at(p.z)}; }

}  // namespace lippmann
