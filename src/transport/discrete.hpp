// Samples an index in proportion to its weight.
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
  /// Weights must be finite and >= 0. Denormal weights count as 0. The distribution is empty if all weights are 0.
  explicit DiscreteDistribution(std::span<const float> weights);

  bool empty() const { return cumulative_.empty(); }
  std::size_t size() const { return cumulative_.size(); }
  double total() const { return total_; }

  /// Returns an index with a positive weight, for u in [0, 1). Sets `rest` to a new random number in [0, 1), made from the
  /// unused digits of u. The distribution must not be empty.
  std::size_t sample(float u, float& rest) const {
    // u * count may be rounded up, which selects the next part.
    const auto count = static_cast<float>(cumulative_.size());
    auto part = std::min(static_cast<std::size_t>(u * count), cumulative_.size() - 1);
    while (part > 0 && start_of(part) > u) --part;
    std::size_t index = first_[part];
    while (cumulative_[index] <= u) ++index;
    const float below = probability_before(index);
    rest = std::min((u - below) / (cumulative_[index] - below), 0x1.fffffep-1f);
    return index;
  }

  float probability(std::size_t index) const { return cumulative_[index] - probability_before(index); }

  float probability_before(std::size_t index) const { return index > 0 ? cumulative_[index - 1] : 0.0f; }

 private:
  float start_of(std::size_t part) const { return std::min(static_cast<float>(part) * step_, 0x1.fffffep-1f); }

  std::vector<float> cumulative_;  ///< for each index, the probability of this index or a lower one; the last entry is 1
  /// Guide table: [0, 1) is divided into equal parts, and first_ holds the index at the start of each part.
  std::vector<std::uint32_t> first_;
  float step_ = 0.0f;
  double total_ = 0.0;
};

}  // namespace lippmann
