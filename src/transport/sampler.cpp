#include "transport/sampler.hpp"

#include "core/random.hpp"

namespace lippmann {
namespace {

LIPPMANN_INLINE std::uint32_t reversed_bits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Flips each bit depending on a hash of the lower bits (Laine and Karras; constants by N. Vegdahl, 2021).
LIPPMANN_INLINE std::uint32_t scrambled_upwards(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// Returns the bit-reversed second dimension of Sobol's sequence. Its generator matrix is Pascal's triangle modulo 2.
LIPPMANN_INLINE std::uint32_t second_sobol_reversed(std::uint32_t index) {
  index ^= index >> 16;
  index ^= (index & 0xff00ff00u) >> 8;
  index ^= (index & 0xf0f0f0f0u) >> 4;
  index ^= (index & 0xccccccccu) >> 2;
  return index ^ ((index & 0xaaaaaaaau) >> 1);
}

struct Point {
  float x, y;
};

/// Computes a point from its bit-reversed index. Scrambling works on reversed bits, so most reversals cancel.
LIPPMANN_INLINE Point point_of(std::uint32_t reversed_index, std::uint32_t seed) {
  // Owen scrambling of the index shuffles the points, but keeps each aligned block of 2^k indices together.
  const std::uint32_t shuffled = reversed_bits(scrambled_upwards(reversed_index, seed));
  const std::uint32_t x = scrambled_upwards(shuffled, hash(seed));
  const std::uint32_t y = scrambled_upwards(second_sobol_reversed(shuffled), hash(~seed));
  return {unit_float(reversed_bits(x)), unit_float(reversed_bits(y))};
}

}  // namespace

Vec2f scrambled_sobol(std::uint32_t index, std::uint32_t seed) {
  const Point p = point_of(reversed_bits(index), hash(seed));
  return {p.x, p.y};
}

LIPPMANN_MULTIVERSION void sample_pairs(const PathPairs& paths, std::uint32_t pair, float* x, float* y) {
#pragma GCC ivdep
  for (int i = 0; i < PathPairs::kPaths; ++i) {
    const Point p = point_of(reversed_bits(paths.index[i]), hash(paths.seed[i], paths.first[i] + pair));
    x[i] = p.x, y[i] = p.y;
  }
}

}  // namespace lippmann
