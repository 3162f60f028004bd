// Divides an animation into units of work, which separate processes, machines or runs render into one folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

/// One or more of the `count` units of a job.
struct Units {
  std::vector<int> indices{1};  ///< numbers of the units, from 1, in ascending order
  int count = 1;
};

/// Parses text such as "7/200" for one unit, or "1-3,5/200" for several units. Throws a usage Error that names `where`.
Units read_units(std::string_view text, const std::string& where);
std::string write_units(const Units& units);

/// Divides `frames` (ascending) into at most `count` units of nearly equal size. The frames i * segment to (i + 1) * segment -
/// 1 stay in one unit, because they are rendered together. The result depends only on the arguments.
std::vector<std::vector<int>> units_of(const std::vector<int>& frames, int segment, int count);

/// Returns the frames of the given units. If there are more units than groups of `segment` frames, the last units are empty.
std::vector<int> frames_of(const Units& units, const std::vector<int>& frames, int segment);

}  // namespace lippmann
