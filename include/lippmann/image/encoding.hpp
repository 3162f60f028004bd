// Encodings of linear light as integer codes.
#pragma once

namespace lippmann {

enum class Encoding {
  kSrgb,             ///< sRGB transfer curve, rounded to nearest
  kTachyonTruncate,  ///< trunc(255 value), which reproduces Tachyon's output byte for byte
};

}  // namespace lippmann
