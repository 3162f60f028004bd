#include "transport/discrete.hpp"

#include <algorithm>
#include <limits>

namespace lippmann {

DiscreteDistribution::DiscreteDistribution(std::span<const float> weights) {
  const auto counted = [](float w) { return w >= std::numeric_limits<float>::min() ? static_cast<double>(w) : 0.0; };
  for (const float w : weights) total_ += counted(w);
  if (!(total_ > 0.0)) return;
  double sum = 0.0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (counted(weights[i]) > 0.0) last = i;
    cumulative_.push_back(static_cast<float>((sum += counted(weights[i])) / total_));
  }
  // All u < 1 must select an index with a positive weight, even if the sum is rounded below 1.
  std::fill(cumulative_.begin() + static_cast<std::ptrdiff_t>(last), cumulative_.end(), 1.0f);
  step_ = 1.0f / static_cast<float>(weights.size());
  for (std::uint32_t part = 0, index = 0; part < weights.size(); ++part) {
    while (cumulative_[index] <= start_of(part)) ++index;
    first_.push_back(index);
  }
}

}  // namespace lippmann
