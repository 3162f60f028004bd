// Finds blocks of pixels that following frames can copy from a key frame, because their pixels provably do not change.
//
// A block of a key frame is settled as long as none of its rays hits a box around a moving object. Shadow rays and mirror rays
// count too. The objects that such a block shows, and the light on them, do not change, so tracing the block again would give
// the same bits. Blocks are tested for several horizons. A horizon is a number of frames, counted from the key frame. Shorter
// horizons have smaller boxes.
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
  /// `every` is the number of frames per key frame, including the key frame. It is at least 2. If it is not given,
  /// choose_span() chooses the number.
  SettledBlocks(const Scene& scene, int display_node, std::optional<int> every);

  /// Returns the boxes that trace_frame() must test in the key frame `key`. Returns no boxes if nothing moves. `last_frame` is
  /// the last frame of the animation.
  std::vector<HorizonBox> boxes(int key, int last_frame) const { return swept_.around(key, horizons_, last_frame); }

  /// Returns whether any block can be settled in the frame after the key frame.
  static bool can_settle(std::span<const HorizonBox> boxes);

  /// Returns how many frames to make from the key frame `key`, including the key frame itself. Chooses the number with the
  /// fewest traced rays per frame. Returns 1 if reuse traces more rays than it saves.
  int choose_span(const TouchedBlocks& blocks, int key, int last_frame) const;

  /// Returns one value per block for the frame `ahead` frames after the key frame. The value is 1 if the block must be traced,
  /// and 0 if it is settled and can be copied.
  std::vector<std::uint8_t> unsettled(const TouchedBlocks& blocks, int ahead) const;

 private:
  int horizon_of(int ahead) const;

  SweptBoxes swept_;
  /// Numbers of frames, including the key frame, in ascending order.
  std::vector<int> horizons_;
  bool fixed_;
};

}  // namespace lippmann
