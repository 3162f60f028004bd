// What a quilt's file name says: name_qs{columns}x{rows}a{aspect}.ending, as Looking Glass's programs read and write it.
//
// aspect: width / height of the display, not of a tile. Other tools also add z{zoom} and f{focus}, which are ignored. Letters
// may be capitals, and a mark of a copy may follow: "room_qs8x6a0.75 (1).png". A space, hyphen or dot may take the place of the
// underscore, or the name may begin with qs, where the aspect is from 0.1 to 10.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lippmann/display/display.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

struct QuiltName {
  ViewGrid tiles;
  double aspect = 1.0;
};

/// The name of the quilt that a display wants.
QuiltName quilt_name_of(const DisplayQuilt& quilt);

/// None if the name says nothing. Throws Error where it says something impossible (no tiles, no aspect).
std::optional<QuiltName> parse_quilt_name(const std::filesystem::path& path);

/// The tiles of a name that has qs{columns}x{rows}, whether or not the rest can be read. For messages.
std::optional<ViewGrid> tiles_in_name(const std::filesystem::path& path);

/// What stands at the end of a name: _qs8x6a0.75.
std::string quilt_ending(const QuiltName& quilt);

/// The path without that in its name; the path itself where the name says nothing. "quilt" takes the place of an empty name.
std::filesystem::path without_quilt_name(const std::filesystem::path& path);

/// The path with that in its name, before the ending, in place of what it had before.
std::filesystem::path with_quilt_name(const std::filesystem::path& path, const QuiltName& quilt);

}  // namespace lippmann
