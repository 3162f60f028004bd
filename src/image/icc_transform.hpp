// Converts samples from the ICC profile of their file to sRGB, and sRGB codes to a printer's profile, with Little CMS.
//
// The rendering intent is relative colorimetric with black point compensation. Colours outside the target's gamut are clipped.
// All functions are thread-safe. Private to src/image.
#pragma once

#include <optional>

#include "image/decode.hpp"

namespace lippmann {

/// Converts grey or RGB samples of 8 or 16 bits. Extra channels do not change. Returns false and changes nothing if the samples
/// are floats, if the profile is damaged or for another number of colours, or in builds without Little CMS.
bool apply_color_profile(FileBytes icc, const PictureHeader& header, Samples& samples);

/// Converts CMYK samples of 8 or 16 bits, whose highest code is full ink, to RGB. Returns nothing if the profile cannot be
/// used, or in builds without Little CMS.
std::optional<Samples> rgb_of_inks(FileBytes icc, const Samples& inks);

/// Returns the number of channels of an output profile: 3 (RGB) or 4 (CMYK). Returns nothing if the profile is damaged or for
/// input only (such as a camera's), or in builds without Little CMS.
std::optional<int> output_channels(FileBytes icc);

/// Converts sRGB codes of 8 or 16 bits to output_channels() channels. Returns nothing if the profile's tables are damaged.
std::optional<Samples> output_codes(FileBytes icc, const Samples& rgb);

}  // namespace lippmann
