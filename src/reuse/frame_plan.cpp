#include "reuse/frame_plan.hpp"

#include <algorithm>

namespace lippmann {

bool is_key_frame(int frame, int every, int last_frame) { return frame % every == 0 || frame == last_frame; }

FrameInterval key_interval(int frame, int every, int last_frame) {
  const int first = frame - frame % every;
  return {first, std::min(first + every, last_frame)};
}

int middle_frame(const FrameInterval& interval) { return interval.first + (interval.last - interval.first) / 2; }

int halving_depth(int every) {
  int depth = 0;
  for (int length = every; length > 1; length = (length + 1) / 2) ++depth;
  return depth;
}

}  // namespace lippmann
