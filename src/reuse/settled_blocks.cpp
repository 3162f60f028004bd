#include "reuse/settled_blocks.hpp"

#include <algorithm>

namespace lippmann {
namespace {

// kKeyCost is the cost of tracing a key frame, including the test of its rays against boxes. kCopyCost is the cost of copying a
// frame. Both are relative to the cost of tracing a frame without the test.
constexpr double kKeyCost = 1.2, kCopyCost = 0.01;

}  // namespace

SettledBlocks::SettledBlocks(const Scene& scene, int display_node, std::optional<int> every)
    : swept_(scene, display_node), horizons_{2, 4, 8, 16, 32, 64}, fixed_(every.has_value()) {
  if (!every) return;
  std::erase_if(horizons_, [&](int frames) { return frames >= *every; });
  horizons_.push_back(*every);
}

bool SettledBlocks::can_settle(std::span<const HorizonBox> boxes) {
  return boxes.empty() || boxes.front().horizon > 0 || boxes.front().bounds.lower.x > -kInfinity;
}

int SettledBlocks::horizon_of(int ahead) const {
  const auto it = std::upper_bound(horizons_.begin(), horizons_.end(), ahead);
  return static_cast<int>(it - horizons_.begin());
}

int SettledBlocks::choose_span(const TouchedBlocks& blocks, int key, int last_frame) const {
  const int farthest = std::min(horizons_.back(), last_frame - key + 1);
  if (fixed_) return farthest;
  double all = 0.0;
  // rays in blocks that must be traced again, for each horizon
  std::vector<double> unsettled(horizons_.size(), 0.0);
  for (std::size_t b = 0; b < blocks.rays.size(); ++b) {
    all += blocks.rays[b];
    for (std::size_t h = blocks.lowest_horizon[b]; h < unsettled.size(); ++h) unsettled[h] += blocks.rays[b];
  }

  int best = 1;
  // `sum` is the cost of all frames so far and `least` the lowest mean cost per frame, relative to tracing a full frame.
  double least = 1.0, sum = kKeyCost;
  for (int frames = 2; frames <= farthest; ++frames) {
    sum += kCopyCost + unsettled[static_cast<std::size_t>(horizon_of(frames - 1))] / all;
    if (sum / frames < least) best = frames, least = sum / frames;
  }
  return best;
}

std::vector<std::uint8_t> SettledBlocks::unsettled(const TouchedBlocks& blocks, int ahead) const {
  const int horizon = horizon_of(ahead);
  std::vector<std::uint8_t> wanted;
  wanted.reserve(blocks.lowest_horizon.size());
  for (const std::uint8_t lowest : blocks.lowest_horizon) wanted.push_back(lowest <= horizon ? 1 : 0);
  return wanted;
}

}  // namespace lippmann
