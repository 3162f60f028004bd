// Choosing one of many by weight: what decides which light, and which texel of an environment, is sampled.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lippmann {

class DiscreteDistribution {
 public:
  DiscreteDistribution() = default;
  /// Weights finite and >= 0, denormal ones count as 0; where all are 0 the distribution is empty.
  explicit DiscreteDistribution(std::span<const float> weights);

  bool empty() const { return cumulative_.empty(); }
  std::size_t size() const { return cumulative_.size(); }
  double total() const { return total_; }

  /// The index for u in [0, 1), never one of weight 0; `rest` (in [0, 1)) is how far u lies in the index's share, and as good
  /// as a new number. Not empty.
  std::size_t sample(float u, float& rest) const {
    // The part of [0, 1) that u lies in; rounding may take it one too far.
    const auto count = static_cast<float>(cumulative_.size());
    auto part = std::min(static_cast<std::size_t>(u * count), cumulative_.size() - 1);
    while (part > 0 && start_of(part) > u) --part;
    std::size_t index = first_[part];
    while (cumulative_[index] <= u) ++index;
    const float below = probability_before(index);
    rest = std::min((u - below) / (cumulative_[index] - below), 0x1.fffffep-1f);
    return index;
  }

  /// The probability of an index.
  float probability(std::size_t index) const { return cumulative_[index] - probability_before(index); }

  /// The probability of all indices before it together.
  float probability_before(std::size_t index) const { return index > 0 ? cumulative_[index - 1] : 0.0f; }

 private:
  float start_of(std::size_t part) const { return std::min(static_cast<float>(part) * step_, 0x1.fffffep-1f); }

  std::vector<float> cumulative_;     ///< share of all up to and including an index; the last is 1
  std::vector<std::uint32_t> first_;  ///< [0, 1) in as many equal parts: the index that each begins in (a "guide table")
  float step_ = 0.0f;                 ///< a part's length
  double total_ = 0.0;
};

}  // namespace lippmann
