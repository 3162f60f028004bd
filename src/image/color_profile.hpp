// Checks whether an ICC profile is sRGB. Private to src/image.
#pragma once

#include <string>
#include <vector>

#include "image/decode.hpp"

namespace lippmann {

/// Returns the notice "its colour profile 'Display P3' is not applied: ..." for PictureHeader. Returns an empty string without
/// a profile, or if it has no visible difference from sRGB.
std::string color_profile_notice(FileBytes icc);

/// Returns the profile for PictureHeader. It is empty without a profile, or if it is sRGB as above.
std::vector<std::byte> profile_to_apply(FileBytes icc);

inline constexpr const char* kInksNotice =
    "its inks (CMYK) have no colour profile that can be applied: its colours are estimates";

}  // namespace lippmann
