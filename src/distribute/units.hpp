// An animation cut into units of work: parts that different processes, machines or days render into one folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

/// One of so many.
struct Unit {
  int index = 1;  ///< from 1
  int count = 1;
};

/// "7/200". Throws a usage Error at `where`.
Unit read_unit(std::string_view text, const std::string& where);
std::string write_unit(const Unit& unit);

/// Cuts frames, which ascend, before multiples of `segment` only (frames_per_segment), into `count` parts or as many as there
/// are segments: none is empty, and their segments differ by one at most. The cut depends on these three alone.
std::vector<std::vector<int>> units_of(const std::vector<int>& frames, int segment, int count);

/// The frames of one unit; none where there are fewer segments than units.
std::vector<int> frames_of(const Unit& unit, const std::vector<int>& frames, int segment);

}  // namespace lippmann
