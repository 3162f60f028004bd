// Discrete sampling by weight, used to choose lights and texels of environments.
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
  /// Weights must be finite and >= 0. Denormal weights count as 0. If all weights are 0, the distribution is empty.
  explicit DiscreteDistribution(std::span<const float> weights);

  bool empty() const { return cumulative_.empty(); }
  std::size_t size() const { return cumulative_.size(); }
  double total() const { return total_; }

  /// Returns the index for u in [0, 1), never one with weight 0. `rest` receives the position of u within the index's share, in
  /// [0, 1), which can serve as a new random number. The distribution must not be empty.
  std::size_t sample(float u, float& rest) const {
    // Find the part of [0, 1) that contains u. Rounding may give the next one.
    const auto count = static_cast<float>(cumulative_.size());
    auto part = std::min(static_cast<std::size_t>(u * count), cumulative_.size() - 1);
    while (part > 0 && start_of(part) > u) --part;
    std::size_t index = first_[part];
    while (cumulative_[index] <= u) ++index;
    const float below = probability_before(index);
    rest = std::min((u - below) / (cumulative_[index] - below), 0x1.fffffep-1f);
    return index;
  }

  /// Returns the probability of an index.
  float probability(std::size_t index) const { return cumulative_[index] - probability_before(index); }

  /// Returns the total probability of all lower indices.
  float probability_before(std::size_t index) const { return index > 0 ? cumulative_[index - 1] : 0.0f; }

 private:
  float start_of(std::size_t part) const { return std::min(static_cast<float>(part) * step_, 0x1.fffffep-1f); }

  std::vector<float> cumulative_;     ///< cumulative shares; the last entry is 1
  std::vector<std::uint32_t> first_;  ///< guide table: splits [0, 1) into equal parts and holds the index at the start of each
  float step_ = 0.0f;                 ///< length of a part
  double total_ = 0.0;
};

}  // namespace lippmann
