#include "transport/sampler.hpp"

#include "core/random.hpp"

namespace lippmann {
namespace {

std::uint32_t reversed_bits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Flips each bit by a hash of the bits below it (Laine and Karras; constants by N. Vegdahl, 2021).
std::uint32_t scrambled_upwards(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// Owen's scrambling: flips each bit by a hash of the bits above it.
std::uint32_t owen_scrambled(std::uint32_t x, std::uint32_t seed) {
  return reversed_bits(scrambled_upwards(reversed_bits(x), seed));
}

/// The second dimension of Sobol's sequence, as 32 bits after the point; the first is reversed_bits.
std::uint32_t second_sobol(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t direction = 0x80000000u; index; index >>= 1, direction ^= direction >> 1)
    if (index & 1u) result ^= direction;
  return result;
}

}  // namespace

Vec2f scrambled_sobol(std::uint32_t index, std::uint32_t seed) {
  // Shuffled: Owen's scrambling of the index itself, which keeps every aligned block of 2^k indices together.
  const std::uint32_t shuffled = owen_scrambled(index, hash(seed, 0u));
  const std::uint32_t x = owen_scrambled(reversed_bits(shuffled), hash(seed, 1u));
  const std::uint32_t y = owen_scrambled(second_sobol(shuffled), hash(seed, 2u));
  return {unit_float(x), unit_float(y)};
}

Vec2f PathSampler::next() { return scrambled_sobol(index_, hash(seed_, pair_++)); }

}  // namespace lippmann
