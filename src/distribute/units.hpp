// An animation cut into units of work: parts that different processes, machines or days render into one folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

/// One of so many, or several that a process renders one after the other: set-up is paid once.
struct Units {
  std::vector<int> indices{1};  ///< from 1, ascending
  int count = 1;
};

/// "7/200"; "1-3,5/200" for several. Throws a usage Error at `where`.
Units read_units(std::string_view text, const std::string& where);
std::string write_units(const Units& units);

/// Cuts frames, which ascend, before multiples of `segment` only (frames_per_segment), into `count` parts or as many as there
/// are segments: none is empty, and their segments differ by one at most. The cut depends on these three alone.
std::vector<std::vector<int>> units_of(const std::vector<int>& frames, int segment, int count);

/// The frames of these units; none where there are fewer segments than units.
std::vector<int> frames_of(const Units& units, const std::vector<int>& frames, int segment);

}  // namespace lippmann
