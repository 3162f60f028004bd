#include "reuse/frame_plan.hpp"

#include <algorithm>

namespace lippmann {

bool is_key_frame(int frame, int every, int last_frame) { return frame % every == 0 || frame == last_frame; }

FrameInterval key_interval(int frame, int every, int last_frame) {
  const int first = frame - frame % every;
  return {first, std::min(first + every, last_frame)};
}

int middle_frame(const FrameInterval& interval) { return interval.first + (interval.last - interval.first) / 2; }

std::vector<FrameInterval> halving_path(int frame, int every, int last_frame) {
  std::vector<FrameInterval> path{key_interval(frame, every, last_frame)};
  while (true) {
    const FrameInterval whole = path.back();
    const int middle = middle_frame(whole);
    if (middle == frame) return path;
    path.push_back(frame < middle ? FrameInterval{whole.first, middle} : FrameInterval{middle, whole.last});
  }
}

int halving_depth(int every) {
  int depth = 0;
  for (int length = every; length > 1; length = (length + 1) / 2) ++depth;
  return depth;
}

}  // namespace lippmann
