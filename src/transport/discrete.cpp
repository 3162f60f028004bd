#include "transport/discrete.hpp"

#include <algorithm>

namespace lippmann {

DiscreteDistribution::DiscreteDistribution(std::span<const float> weights) {
  for (const float w : weights) total_ += static_cast<double>(w);
  if (!(total_ > 0.0)) return;
  double sum = 0.0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0.0f) last = i;
    cumulative_.push_back(static_cast<float>((sum += static_cast<double>(weights[i])) / total_));
  }
  // Whatever the rounding, u < 1 finds an index that has weight.
  std::fill(cumulative_.begin() + static_cast<std::ptrdiff_t>(last), cumulative_.end(), 1.0f);
  for (std::uint32_t part = 0, index = 0; part < weights.size(); ++part) {
    while (cumulative_[index] <= start_of(part)) ++index;
    first_.push_back(index);
  }
}

std::size_t DiscreteDistribution::sample(float u, float& rest) const {
  // The part of [0, 1) that u lies in; rounding may take it one too far.
  const auto count = static_cast<float>(cumulative_.size());
  auto part = std::min(static_cast<std::size_t>(u * count), cumulative_.size() - 1);
  if (part > 0 && start_of(part) > u) --part;
  std::size_t index = first_[part];
  while (cumulative_[index] <= u) ++index;
  const float below = index > 0 ? cumulative_[index - 1] : 0.0f;
  rest = std::min((u - below) / (cumulative_[index] - below), 0x1.fffffep-1f);
  return index;
}

float DiscreteDistribution::start_of(std::size_t part) const {
  return static_cast<float>(part) / static_cast<float>(cumulative_.size());
}

float DiscreteDistribution::probability(std::size_t index) const {
  return cumulative_[index] - (index > 0 ? cumulative_[index - 1] : 0.0f);
}

}  // namespace lippmann
