// Whether an ICC profile says what readers take for granted: that codes are sRGB's. Private to src/image.
#pragma once

#include <string>

#include "image/decode.hpp"

namespace lippmann {

/// "its colour profile 'Display P3' is not applied: ...", a notice of PictureHeader; empty if the profile is sRGB's within what
/// an eye sees, or there is none.
std::string color_profile_notice(FileBytes icc);

}  // namespace lippmann
