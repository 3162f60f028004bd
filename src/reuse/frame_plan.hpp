// Chooses which frames of an animation are traced, and from which two source frames each other frame is made.
//
// Every K-th frame, counted from frame 0, is a key frame. The last frame is a key frame too. The plan depends on the whole
// animation and not on the requested frames, so rendering a part later gives the same frames. A frame between two key frames is
// made directly from both, or by halving, a recursive interpolation:
// 1. Make the middle frame of the interval from both ends. Of two middle frames, take the earlier one.
// 2. Repeat step 1 with each half. Frames made in step 1 are sources like traced frames.
#pragma once

#include <vector>

namespace lippmann {

/// The frames between `first` and `last`, without `first` and `last`.
struct FrameInterval {
  int first = 0, last = 0;
  bool operator==(const FrameInterval&) const = default;
};

/// Returns whether a frame is a key frame. `every` is K, at least 1.
bool is_key_frame(int frame, int every, int last_frame);

/// Returns the two key frames around a frame. The frame itself must not be a key frame.
FrameInterval key_interval(int frame, int every, int last_frame);

int middle_frame(const FrameInterval& interval);

/// Returns the intervals that halving visits until it makes the frame. Begins with the interval between key frames, and ends
/// with the interval whose middle frame is `frame`. The frame itself must not be a key frame.
std::vector<FrameInterval> halving_path(int frame, int every, int last_frame);

/// Returns how often the interval between key frames can be halved. At most halving_depth() - 1 made frames are needed as
/// sources at the same time.
int halving_depth(int every);

}  // namespace lippmann
