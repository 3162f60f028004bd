// Converts samples from the ICC profile of their file to sRGB, and sRGB codes to a printer's profile. This requires Little CMS.
//
// The rendering intent is relative colorimetric with black point compensation. Colours outside the target's gamut are clipped.
// All functions are thread-safe. Private to src/image.
#pragma once

#include <optional>

#include "image/decode.hpp"

namespace lippmann {

/// Converts grey or RGB samples of 8 or 16 bits by a profile for grey or RGB. Extra channels do not change. Returns false and
/// leaves the samples unchanged in these cases: the samples are floats, the profile is damaged, the profile is for another
/// number of colours, or the program is built without Little CMS.
bool apply_color_profile(FileBytes icc, const PictureHeader& header, Samples& samples);

/// Converts CMYK samples of 8 or 16 bits, where the highest code is full ink. Returns RGB codes. Returns nothing if the profile
/// cannot be used or if the program is built without Little CMS.
std::optional<Samples> rgb_of_inks(FileBytes icc, const Samples& inks);

/// Returns the number of channels of an output profile: 3 (RGB) or 4 (CMYK). Returns nothing if the profile is damaged, if it
/// is for input only (such as a camera's profile), or if the program is built without Little CMS.
std::optional<int> output_channels(FileBytes icc);

/// Converts sRGB codes of 8 or 16 bits to codes of an output profile, which has output_channels() channels. Returns nothing if
/// the profile's tables are damaged.
std::optional<Samples> output_codes(FileBytes icc, const Samples& rgb);

}  // namespace lippmann
