#pragma once

#include <cstddef>
#include <cstdint>

namespace lippmann::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x2545f4914f6cdd1du) {}

  /// SplitMix64
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

  bool once_in(std::size_t count) { return count > 0 && below(count) == 0; }

 private:
  std::uint64_t state_;
};

}  // namespace lippmann::test
