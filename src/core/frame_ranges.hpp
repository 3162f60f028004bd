// Frames of an animation as they are asked for: 0,2,4 or 0-10:2,20.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

/// Every step-th frame of an animation from `first` on, up to `last`.
struct FrameRange {
  int first = 0;
  int last = 0;
  int step = 1;  ///< >= 1
  bool operator==(const FrameRange&) const = default;
};

/// In any order; they may overlap.
using FrameRanges = std::vector<FrameRange>;

/// The frames of the ranges, each once, ascending.
std::vector<int> frames_of(const FrameRanges& ranges);

/// The fewest ranges of neighbours that hold these frames, which ascend.
FrameRanges ranges_of(const std::vector<int>& frames);

/// "3-7", "3" for one frame, "0-10:2" for every second one, and several of these with commas between. Throws a usage Error at
/// `where` that says what would be accepted.
FrameRanges read_frames(std::string_view text, const std::string& where);
std::string write_frames(const FrameRanges& frames);

}  // namespace lippmann
