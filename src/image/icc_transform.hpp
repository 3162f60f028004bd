// Turns samples into sRGB's codes through the ICC profile of their file, by Little CMS, where the program is built with it.
//
// Relative colorimetric with black point compensation; what sRGB cannot show is clipped. All functions may be called from
// several threads. Private to src/image.
#pragma once

#include <optional>

#include "image/decode.hpp"

namespace lippmann {

/// Colours of a picture: grey or RGB by a profile of the same kind, 8 or 16 bits. Further channels stay. Returns whether they
/// were turned: they stay as they are if the profile is damaged or of another kind, for floats, and without Little CMS.
bool apply_color_profile(FileBytes icc, const PictureHeader& header, Samples& samples);

/// Cyan, magenta, yellow and black, 4 samples a pixel of 8 or 16 bits, the highest code is full ink. Returns RGB codes; nothing
/// if the profile cannot be used, or without Little CMS.
std::optional<Samples> rgb_of_inks(FileBytes icc, const Samples& inks);

}  // namespace lippmann
