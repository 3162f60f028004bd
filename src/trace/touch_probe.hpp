// Tests rays against boxes while they are traced (touched_blocks.hpp). Private to src/trace.
#pragma once

#include <vector>

#include "trace/embree_shim.hpp"
#include "trace/touched_blocks.hpp"

namespace lippmann {

/// The boxes, ready for tests. Thread-safe.
class TouchProbe {
 public:
  TouchProbe(RTCDevice device, int native_width, const std::vector<HorizonBox>& boxes);
  TouchProbe(const TouchProbe&) = delete;
  TouchProbe& operator=(const TouchProbe&) = delete;

  /// The lowest horizon of the boxes that the active rays meet from tnear to tfar: how far they went, or are about to go.
  std::uint8_t lowest_met(const RayPacket& rays, const LaneMask& active) const;

  /// Those of the active rays that meet any box.
  LaneMask met(const RayPacket& rays, const LaneMask& active) const;

 private:
  struct Box {
    Vec3f lower, upper;
    float horizon;
  };
  void find_lowest(const RayPacket& rays, const LaneMask& active, float* lowest) const;
  static void bounds(const RTCBoundsFunctionArguments* args);
  static void meet(const RTCOccludedFunctionNArguments* args);

  std::vector<Box> boxes_;                           ///< finite ones, padded
  std::uint8_t everything_ = TouchedBlocks::kNever;  ///< lowest horizon of the boxes without end
  EmbreeScene scene_;                                ///< of boxes_
  int native_width_;
};

/// The lowest horizon that the rays of one block have met so far.
class BlockProbe {
 public:
  explicit BlockProbe(const TouchProbe& probe) : probe_(probe) {}

  void add(const RayPacket& rays, const LaneMask& active) {
    if (lowest_ > 0) lowest_ = std::min(lowest_, probe_.lowest_met(rays, active));
  }
  /// What the block has met; from now on about the next one.
  std::uint8_t take() { return std::exchange(lowest_, TouchedBlocks::kNever); }

 private:
  const TouchProbe& probe_;
  std::uint8_t lowest_ = TouchedBlocks::kNever;
};

}  // namespace lippmann
