// Exact reuse in time: blocks of pixels that provably stay as they are over the frames to come, which copy them.
//
// A block of a key frame is settled for as long as none of its rays (to the surfaces, to the lights, along mirrors) meets a box
// around anything that moves: then it sees and is lit by the same things, and tracing it again would give the same bits.
// How far that holds is told apart in horizons, numbers of frames from the key on: the boxes of nearer horizons are smaller.
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
  /// every: how many frames a key serves, itself among them, from 2; none: chosen by choose_span.
  SettledBlocks(const Scene& scene, int display_node, std::optional<int> every);

  /// What to have trace_frame look for in a key frame. last_frame: where the animation ends. None at all: nothing moves.
  std::vector<HorizonBox> boxes(int key, int last_frame) const { return swept_.around(key, horizons_, last_frame); }

  /// Whether any block can be settled in the frame after the key.
  static bool can_settle(std::span<const HorizonBox> boxes);

  /// How many frames, the key among them, are best made from a key with these blocks: so many that the fewest rays per frame
  /// are traced. 1: no reuse pays.
  int choose_span(const TouchedBlocks& blocks, int key, int last_frame) const;

  /// By block, 1 for those to trace in the frame `ahead` frames after the key: they are not settled so long.
  std::vector<std::uint8_t> unsettled(const TouchedBlocks& blocks, int ahead) const;

 private:
  int horizon_of(int ahead) const;

  SweptBoxes swept_;
  std::vector<int> horizons_;  ///< frames, the key among them; ascending
  bool fixed_;
};

}  // namespace lippmann
