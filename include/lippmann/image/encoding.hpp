// How the film's linear values become the codes of a picture file.
#pragma once

namespace lippmann {

enum class Encoding {
  kSrgb,             ///< sRGB transfer curve, rounded to nearest
  kTachyonTruncate,  ///< trunc(255 value): display-referred scenes of Tachyon, compared byte for byte with its output
};

}  // namespace lippmann
