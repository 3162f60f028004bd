// Checks whether an ICC profile differs visibly from sRGB. Private to src/image.
#pragma once

#include <string>
#include <vector>

#include "image/decode.hpp"

namespace lippmann {

/// Returns a notice such as "its colour profile 'Display P3' is not applied: ...", or an empty string if there is no profile or
/// if it looks like sRGB.
std::string color_profile_notice(FileBytes icc);

/// Returns the profile, or nothing if there is none or if it looks like sRGB.
std::vector<std::byte> profile_to_apply(FileBytes icc);

inline constexpr const char* kInksNotice =
    "its inks (CMYK) have no colour profile that can be applied: its colours are estimates";

}  // namespace lippmann
