// Converts samples from the ICC profile of their file to sRGB, and sRGB codes to a printer's profile, if the program is built
// with Little CMS.
//
// The intent is relative colorimetric with black point compensation; colours outside the target's gamut are clipped. All
// functions are thread-safe. Private to src/image.
#pragma once

#include <optional>

#include "image/decode.hpp"

namespace lippmann {

/// Converts grey or RGB samples of 8 or 16 bits by a profile of the same kind; extra channels do not change. Returns false and
/// leaves the samples unchanged if they are floats, if the profile is damaged or of another kind, or without Little CMS.
bool apply_color_profile(FileBytes icc, const PictureHeader& header, Samples& samples);

/// Converts cyan, magenta, yellow and black, 4 samples of 8 or 16 bits per pixel with the highest code for full ink. Returns
/// RGB codes, or nothing if the profile cannot be used or without Little CMS.
std::optional<Samples> rgb_of_inks(FileBytes icc, const Samples& inks);

/// Returns the number of channels of an output profile: 3 (RGB) or 4 (inks). Returns nothing if the profile is damaged or not
/// an output profile, such as a camera's, and without Little CMS.
std::optional<int> output_channels(FileBytes icc);

/// Converts sRGB codes of 8 or 16 bits to codes of an output profile with output_channels(). Returns nothing if its tables are
/// damaged.
std::optional<Samples> output_codes(FileBytes icc, const Samples& rgb);

}  // namespace lippmann
