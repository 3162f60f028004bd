// Reads and writes quilt file names: name_qs{columns}x{rows}a{aspect}.ending, the convention of Looking Glass's programs.
//
// aspect: width / height of the display, not of a tile. z{zoom} and f{focus}, which some tools add, are ignored. Upper case and
// a copy mark are accepted: "room_qs8x6a0.75 (1).png". If the aspect is within 0.1 ... 10, a space, hyphen or dot may replace
// the underscore, or the name may begin with qs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lippmann/display/display.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

struct QuiltName {
  ViewGrid tiles{};
  double aspect = 1.0;
};

/// Returns the tiles and the aspect of a display's quilt.
QuiltName quilt_name_of(const DisplayQuilt& quilt);

/// Returns none if the name has no quilt part. Throws Error for zero tiles or aspect.
std::optional<QuiltName> parse_quilt_name(const std::filesystem::path& path);

/// Returns the tiles in qs{columns}x{rows}, even if the rest of the name cannot be parsed.
std::optional<ViewGrid> tiles_in_name(const std::filesystem::path& path);

/// Returns the quilt part of a file name, for example _qs8x6a0.75.
std::string quilt_ending(const QuiltName& quilt);

/// Removes the quilt part of the name. If nothing else is left, the name becomes "quilt".
std::filesystem::path without_quilt_name(const std::filesystem::path& path);

/// Adds or replaces the quilt part before the ending.
std::filesystem::path with_quilt_name(const std::filesystem::path& path, const QuiltName& quilt);

}  // namespace lippmann
