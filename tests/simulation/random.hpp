// Random numbers for a simulated story. All numbers follow from the seed.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lippmann::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x2545f4914f6cdd1du) {}

  /// Returns the next number of the SplitMix64 generator.
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// Returns a number from 0 to count - 1. `count` must be at least 1.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

  /// Returns true with the probability 1 / count, and never if `count` is 0.
  bool once_in(std::size_t count) { return count > 0 && below(count) == 0; }

 private:
  std::uint64_t state_;
};

}  // namespace lippmann::test
