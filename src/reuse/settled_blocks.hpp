// Finds blocks of pixels that following frames can copy from a key frame, because their pixels provably do not change.
//
// A block of a key frame is settled as long as none of its rays, shadow rays and mirror rays included, hits a box around a
// moving object. Tracing the block again would give the same bits. Blocks are tested for several horizons. A horizon is a
// number of frames, counted from the key frame.
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
  /// `every` is the number of frames from one key frame to the next, at least 2. If not given, choose_span() chooses it.
  SettledBlocks(const Scene& scene, int display_node, std::optional<int> every);

  std::vector<HorizonBox> boxes(int key, int last_frame) const { return swept_.around(key, horizons_, last_frame); }

  static bool can_settle(std::span<const HorizonBox> boxes);

  /// Returns the number of frames from one key frame to the next for which the fewest rays per frame are traced. Returns 1 if
  /// reuse saves no rays.
  int choose_span(const TouchedBlocks& blocks, int key, int last_frame) const;

  /// Returns 1 for each block that must be traced in the frame `ahead` frames after the key frame, and 0 for each block that
  /// can be copied.
  std::vector<std::uint8_t> unsettled(const TouchedBlocks& blocks, int ahead) const;

 private:
  int horizon_of(int ahead) const;

  SweptBoxes swept_;
  std::vector<int> horizons_;
  bool fixed_;
};

}  // namespace lippmann
