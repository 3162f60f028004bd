// Turns samples into sRGB's codes through the ICC profile of their file, and sRGB's codes into those of a printer's profile, by
// Little CMS, where the program is built with it.
//
// Relative colorimetric with black point compensation; what the target cannot show is clipped. All functions may be called from
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

/// How many channels the codes of an output profile have: 3 (RGB) or 4 (inks). Returns nothing for profiles that are damaged or
/// of another kind, such as that of a camera, which nothing can be turned into, and without Little CMS.
std::optional<int> output_channels(FileBytes icc);

/// sRGB's codes, 8 or 16 bits, as codes of an output profile with output_channels(). Returns nothing if its tables are damaged.
std::optional<Samples> output_codes(FileBytes icc, const Samples& rgb);

}  // namespace lippmann
