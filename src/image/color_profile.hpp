// Whether an ICC profile says what readers take for granted: that codes are sRGB's. Private to src/image.
#pragma once

#include <string>
#include <vector>

#include "image/decode.hpp"

namespace lippmann {

/// "its colour profile 'Display P3' is not applied: ...", a notice of PictureHeader; empty if the profile is sRGB's within what
/// an eye sees, or there is none.
std::string color_profile_notice(FileBytes icc);

/// The profile, for PictureHeader; empty if there is none, or it is sRGB's as above.
std::vector<std::byte> profile_to_apply(FileBytes icc);

inline constexpr const char* kInksNotice =
    "its inks (CMYK) have no colour profile that can be applied: its colours are estimates";

}  // namespace lippmann
