// Which frames of an animation are traced, and which two each of the others is made from.
//
// Key frames are every K-th frame from frame 0, and the last. The plan depends on the animation alone, not on which of its
// frames are asked for, so that a part of it rendered later is the same. Frames between two keys are made straight from
// both, or by halving (the paper's recursive interpolation): the frame in the middle of the interval first (the earlier one of
// two), from the interval's ends; then the middles of both halves, from their own ends, and so on: a made frame is a source
// like a traced one.
#pragma once

#include <vector>

namespace lippmann {

/// Frames between two others: first < frame < last.
struct FrameInterval {
  int first = 0, last = 0;
  bool operator==(const FrameInterval&) const = default;
};

/// `every` >= 1.
bool is_key_frame(int frame, int every, int last_frame);

/// The key frames around a frame that is none.
FrameInterval key_interval(int frame, int every, int last_frame);

/// The frame that halving makes first: first + (last - first) / 2.
int middle_frame(const FrameInterval& interval);

/// What halving goes through until it makes a frame that is no key: the key interval first, last the one whose middle it is.
std::vector<FrameInterval> halving_path(int frame, int every, int last_frame);

/// How often an interval between keys can be halved: how many made frames may be sources at a time, and one more.
int halving_depth(int every);

}  // namespace lippmann
