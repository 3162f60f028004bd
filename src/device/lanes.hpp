#pragma once

#include <cstddef>
#include <cstdint>

#include "core/multiversion.hpp"
#include "lippmann/core/math.hpp"

namespace lippmann {

inline constexpr int kLanes = 16;
constexpr std::size_t packets_of(std::size_t rays) { return (rays + kLanes - 1) / kLanes; }
/// Loops over the lanes of a packet. The iterations must be independent. Without the pragma, the compiler would have to assume
/// that the arrays of a packet overlap, and would not vectorise the loop.
#define LIPPMANN_FOR_LANES(i) _Pragma("GCC ivdep") for (int i = 0; i < kLanes; ++i)

/// Active lanes are -1, and inactive lanes 0.
struct alignas(64) LaneMask {
  int lane[kLanes];
};

inline bool any(const LaneMask& lanes) {
  int any = 0;
  for (const int lane : lanes.lane) any |= lane;
  return any != 0;
}

struct alignas(64) Lanes {
  float lane[kLanes];
  LIPPMANN_INLINE float& operator[](int i) { return lane[i]; }
  LIPPMANN_INLINE float operator[](int i) const { return lane[i]; }
};

struct alignas(64) Lanes3 {
  Lanes x, y, z;
  LIPPMANN_INLINE void set(int i, Vec3f v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
  LIPPMANN_INLINE Vec3f get(int i) const { return {x[i], y[i], z[i]}; }
};

}  // namespace lippmann
