// Divides an animation into units of work, which separate processes, machines or runs render into one folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

/// One or more of `count` units. A process that renders several sets up the scene only once.
struct Units {
  std::vector<int> indices{1};  ///< from 1, ascending
  int count = 1;
};

/// Parses text such as "7/200", or "1-3,5/200" for several units. Throws a usage Error that names `where`.
Units read_units(std::string_view text, const std::string& where);
std::string write_units(const Units& units);

/// Divides ascending frames into `count` units, or into one unit per segment if there are fewer segments. The frames between
/// two multiples of `segment` (frames_per_segment) stay in one unit. No unit is empty, and the numbers of segments differ by at
/// most one. The result depends only on the arguments.
std::vector<std::vector<int>> units_of(const std::vector<int>& frames, int segment, int count);

/// Returns the frames of these units. Units beyond the number of segments have no frames.
std::vector<int> frames_of(const Units& units, const std::vector<int>& frames, int segment);

}  // namespace lippmann
