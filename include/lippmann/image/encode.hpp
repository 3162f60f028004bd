// Converts linear film values to integer codes of image files.
//
// The result has 3 channels: the first three of the film, or its first one repeated if it has fewer than three. Values below 0
// give code 0, values above 1 give the highest code, and NaN gives code 0.
//   kSrgb             code = floor(max srgb(v) + 1/2), with srgb() in double precision: exact for every float.
//   kTachyonTruncate  code = trunc(max v), with the product in single precision, as Tachyon does.
// max is 255 or 65535.
#pragma once

#include <cstddef>

#include "lippmann/image/encoding.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns the codes of a film. nan_count: if not null, receives the number of NaN samples in all channels.
Image8 to_codes(const Image& film, Encoding encoding, std::size_t* nan_count = nullptr);
Image16 to_codes16(const Image& film, Encoding encoding, std::size_t* nan_count = nullptr);

/// Returns the codes of an alpha image (one channel): floor(max alpha + 1/2).
std::vector<unsigned char> alpha_codes(const Image& alpha);
std::vector<std::uint16_t> alpha_codes16(const Image& alpha);

/// Divides premultiplied colours by alpha in place; colours become 0 where alpha is 0. alpha: 1 channel; film: 3 channels, same
/// size.
void divide_by_alpha(const Image& alpha, Image& film);

/// The sRGB transfer curve of IEC 61966-2-1:1999 for linear values in [0, 1], and its inverse.
double srgb_from_linear(double linear);
double linear_from_srgb(double srgb);

}  // namespace lippmann
