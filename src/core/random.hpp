// Random numbers as hashes of seed, frame, pixel and sample, so that they do not depend on the order of work or on threads.
//
// The integers are mixed like those of a PCG generator, after: Jarzynski, Olano, "Hash Functions for GPU Rendering", JCGT 9(3),
// 2020.
#pragma once

#include <cstdint>

#include "core/multiversion.hpp"

namespace lippmann {

LIPPMANN_INLINE std::uint32_t hash(std::uint32_t x) {
  const std::uint32_t state = x * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}
LIPPMANN_INLINE std::uint32_t hash(std::uint32_t a, std::uint32_t b) { return hash(a ^ hash(b)); }
LIPPMANN_INLINE std::uint32_t hash(std::uint32_t a, std::uint32_t b, std::uint32_t c) { return hash(a ^ hash(b, c)); }
LIPPMANN_INLINE std::uint32_t hash(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return hash(a ^ hash(b, c, d));
}

LIPPMANN_INLINE float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

}  // namespace lippmann
