// Exact temporal reuse: following frames copy blocks of pixels that provably do not change.
//
// A block of a key frame is settled while none of its rays (to surfaces, to lights, along mirrors) hits a box around a moving
// object: the objects that it shows and that light it are then unchanged, and tracing it again would give the same bits. Blocks
// are tested for several horizons, which are numbers of frames counted from the key; shorter horizons have smaller boxes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "device/touched_blocks.hpp"
#include "reuse/swept_boxes.hpp"

namespace lippmann {

class SettledBlocks {
 public:
  /// every: number of frames per key, including the key, at least 2. Without it, choose_span() chooses the number.
  SettledBlocks(const Scene& scene, int display_node, std::optional<int> every);

  /// Returns the boxes that trace_frame() must test in a key frame, or none if nothing moves. last_frame: last frame of the
  /// animation.
  std::vector<HorizonBox> boxes(int key, int last_frame) const { return swept_.around(key, horizons_, last_frame); }

  /// Returns whether any block can be settled in the frame after the key.
  static bool can_settle(std::span<const HorizonBox> boxes);

  /// Returns the number of frames, including the key, to make from a key with these blocks. It minimises the rays traced per
  /// frame. Returns 1 if reuse does not pay off.
  int choose_span(const TouchedBlocks& blocks, int key, int last_frame) const;

  /// Returns 1 for each block that must be traced in the frame `ahead` frames after the key, because it is not settled for that
  /// long, and 0 for the others.
  std::vector<std::uint8_t> unsettled(const TouchedBlocks& blocks, int ahead) const;

 private:
  int horizon_of(int ahead) const;

  SweptBoxes swept_;
  std::vector<int> horizons_;  ///< numbers of frames, including the key; ascending
  bool fixed_;
};

}  // namespace lippmann
