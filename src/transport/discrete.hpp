// Choosing one of many by weight: what decides which light, and which texel of an environment, is sampled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lippmann {

class DiscreteDistribution {
 public:
  DiscreteDistribution() = default;
  /// Weights finite and >= 0; where all are 0 the distribution is empty.
  explicit DiscreteDistribution(std::span<const float> weights);

  bool empty() const { return cumulative_.empty(); }
  std::size_t size() const { return cumulative_.size(); }
  double total() const { return total_; }

  /// The index for u in [0, 1), never one of weight 0; `rest` (in [0, 1)) is how far u lies in the index's share, and as good
  /// as a new number. Not empty.
  std::size_t sample(float u, float& rest) const;

  /// The probability of an index.
  float probability(std::size_t index) const;

 private:
  float start_of(std::size_t part) const;

  std::vector<float> cumulative_;     ///< share of all up to and including an index; the last is 1
  std::vector<std::uint32_t> first_;  ///< [0, 1) in as many equal parts: the index that each begins in (a "guide table")
  double total_ = 0.0;
};

}  // namespace lippmann
