// Selections of an animation's frames, such as 0,2,4 or 0-10:2,20.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

struct FrameRange {
  int first = 0;
  int last = 0;
  int step = 1;
  bool operator==(const FrameRange&) const = default;
};

using FrameRanges = std::vector<FrameRange>;

/// Returns the frames of the ranges, each once, in ascending order.
std::vector<int> frames_of(const FrameRanges& ranges);

/// Returns the smallest number of ranges of consecutive frames that cover an ascending list.
FrameRanges ranges_of(const std::vector<int>& frames);

/// Parses "3-7", "3" for one frame, "0-10:2" for every second one, or several of these separated by commas. Throws a usage
/// Error at `where`.
FrameRanges read_frames(std::string_view text, const std::string& where);
std::string write_frames(const FrameRanges& frames);

}  // namespace lippmann
