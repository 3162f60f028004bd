// Tests rays against boxes while the rays are traced. Each box has a horizon, a number assigned by the caller
// (touched_blocks.hpp).
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "device/ray_scene.hpp"
#include "device/touched_blocks.hpp"

namespace lippmann {

class TouchProbe {
 public:
  TouchProbe(const RayScene& scene, const std::vector<HorizonBox>& boxes);
  ~TouchProbe();
  TouchProbe(const TouchProbe&) = delete;
  TouchProbe& operator=(const TouchProbe&) = delete;

  /// Returns the lowest horizon of the boxes that the active rays hit between tnear and tfar, or kNever if they hit none.
  std::uint8_t lowest_met(const RayPacket& rays, const LaneMask& active) const;

 private:
  struct Boxes;
  std::unique_ptr<Boxes> boxes_;
  std::uint8_t everything_ = TouchedBlocks::kNever;  ///< lowest horizon of the infinite boxes, which all rays hit
};

/// Collects the lowest horizon (HorizonBox::horizon) of the boxes that the rays of one block hit.
class BlockProbe {
 public:
  explicit BlockProbe(const TouchProbe& probe) : probe_(probe) {}

  void add(const RayPacket& rays, const LaneMask& active) {
    if (lowest_ > 0) lowest_ = std::min(lowest_, probe_.lowest_met(rays, active));
  }
  /// Returns the lowest horizon, and resets the probe for the next block.
  std::uint8_t take() { return std::exchange(lowest_, TouchedBlocks::kNever); }

 private:
  const TouchProbe& probe_;
  std::uint8_t lowest_ = TouchedBlocks::kNever;
};

}  // namespace lippmann
