// Chooses which frames of an animation are traced, and from which two source frames each other frame is made.
//
// Every K-th frame, counted from frame 0, is a key frame. The last frame is a key frame too. The plan does not depend on which
// frames are requested. A frame between two key frames is made directly from both, or by halving, a recursive interpolation:
// 1. Make the middle frame of the interval from both ends. Of two middle frames, take the earlier one.
// 2. Repeat step 1 with each half. Frames made in step 1 are sources like traced frames.
#pragma once

#include <vector>

namespace lippmann {

/// The frames between `first` and `last`, both excluded.
struct FrameInterval {
  int first = 0, last = 0;
  bool operator==(const FrameInterval&) const = default;
};

bool is_key_frame(int frame, int every, int last_frame);

FrameInterval key_interval(int frame, int every, int last_frame);

int middle_frame(const FrameInterval& interval);

/// Returns the intervals that halving visits, from the interval between two key frames to the interval whose middle is `frame`.
std::vector<FrameInterval> halving_path(int frame, int every, int last_frame);

int halving_depth(int every);

}  // namespace lippmann
