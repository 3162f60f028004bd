// Converts linear film values to integer codes of image files.
//
// The result has 3 channels: the first three of the film, or three copies of the first. Values below 0 and NaN give code 0,
// values above 1 the highest code `max` (255 or 65535). Other values v give:
//   kSrgb             code = floor(max srgb(v) + 1/2), computed in double precision
//   kTachyonTruncate  code = trunc(max v), computed in single precision as in Tachyon
#pragma once

#include <cstddef>

#include "lippmann/image/encoding.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Return the codes of a film. `nan_count`, if not null, receives the number of NaN samples.
Image8 to_codes(const Image& film, Encoding encoding, std::size_t* nan_count = nullptr);
Image16 to_codes16(const Image& film, Encoding encoding, std::size_t* nan_count = nullptr);

/// Return floor(max alpha + 1/2) for each alpha value, where max is 255 or 65535.
std::vector<unsigned char> alpha_codes(const Image& alpha);
std::vector<std::uint16_t> alpha_codes16(const Image& alpha);

/// Divides premultiplied colours by alpha (1 channel). Colours become 0 where alpha is 0. `film` has 3 channels and the size of
/// `alpha`.
void divide_by_alpha(const Image& alpha, Image& film);

/// sRGB transfer curve of IEC 61966-2-1:1999 for linear values in [0, 1], and its inverse.
double srgb_from_linear(double linear);
double linear_from_srgb(double srgb);

}  // namespace lippmann
