// Turns film values into the integer codes of picture files.
//
// Codes have 3 channels: pictures of 3 or more give their first three, of 1 or 2 their first one three times. Values below 0
// give the lowest code, above 1 the highest, NaN gives 0.
//   kSrgb             code = floor(max srgb(v) + 1/2), srgb as below, computed in double precision: exact for every float.
//   kTachyonTruncate  code = trunc(max v), the product in single precision, as Tachyon does.
// max is 255 or 65535.
#pragma once

#include <cstddef>

#include "lippmann/image/encoding.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// `nan_count`, where given, receives the number of samples of the film (all channels) that are NaN.
Image8 to_codes(const Image& film, Encoding encoding, std::size_t* nan_count = nullptr);
Image16 to_codes16(const Image& film, Encoding encoding, std::size_t* nan_count = nullptr);

/// The codes of alpha, floor(max alpha + 1/2), for an Image of one channel.
std::vector<unsigned char> alpha_codes(const Image& alpha);
std::vector<std::uint16_t> alpha_codes16(const Image& alpha);

/// Divides colours that are multiplied by alpha, as light is, by it; where alpha is 0 they become 0. Of equal size, 3 and 1
/// channels.
void divide_by_alpha(const Image& alpha, Image& film);

/// The transfer curve of IEC 61966-2-1:1999 (sRGB) for linear values in [0, 1], and its inverse.
double srgb_from_linear(double linear);
double linear_from_srgb(double srgb);

}  // namespace lippmann
