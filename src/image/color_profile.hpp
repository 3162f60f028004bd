// Checks whether an ICC profile differs visibly from sRGB. Private to src/image.
#pragma once

#include <string>
#include <vector>

#include "image/decode.hpp"

namespace lippmann {

/// Returns the notice for PictureHeader that the profile is not applied: "its colour profile 'Display P3' is not applied: ...".
/// Returns an empty string if there is no profile, or if it has no visible difference from sRGB.
std::string color_profile_notice(FileBytes icc);

/// Returns the profile for PictureHeader. Returns an empty list if there is no profile, or if it has no visible difference from
/// sRGB.
std::vector<std::byte> profile_to_apply(FileBytes icc);

inline constexpr const char* kInksNotice =
    "its inks (CMYK) have no colour profile that can be applied: its colours are estimates";

}  // namespace lippmann
