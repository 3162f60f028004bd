// Selects the frames of an animation to trace, and the two source frames of each other frame.
//
// Key frames are every K-th frame from frame 0, and the last one. The plan depends on the whole animation, not on the requested
// frames, so rendering a part later gives the same result. Frames between two keys are made directly from both, or by halving
// (the paper's recursive interpolation). Halving first makes the middle frame of the interval (the earlier one of two) from the
// interval's ends, then the middle frame of each half from that half's ends, and so on. A frame made this way is a source like
// a traced one.
#pragma once

#include <vector>

namespace lippmann {

/// The frames strictly between `first` and `last`.
struct FrameInterval {
  int first = 0, last = 0;
  bool operator==(const FrameInterval&) const = default;
};

/// Returns whether a frame is a key frame. `every` must be >= 1.
bool is_key_frame(int frame, int every, int last_frame);

/// Returns the key frames around a frame that is not a key.
FrameInterval key_interval(int frame, int every, int last_frame);

/// Returns the frame that halving makes first: first + (last - first) / 2.
int middle_frame(const FrameInterval& interval);

/// Returns the intervals that halving visits to make a frame that is not a key: from the key interval to the interval whose
/// middle it is.
std::vector<FrameInterval> halving_path(int frame, int every, int last_frame);

/// Returns how often an interval between keys can be halved. This is one more than the maximum number of made frames that are
/// sources at the same time.
int halving_depth(int every);

}  // namespace lippmann
