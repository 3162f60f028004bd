// Turns images upright that a camera or a scanner stored rotated or mirrored. Private to src/image.
#pragma once

#include "image/decode.hpp"

namespace lippmann {

/// Returns kUpright for numbers outside 1 to 8.
Orientation orientation_of(unsigned number);

/// Width and height are exchanged if rows become columns.
PictureHeader upright(PictureHeader header);
DecodedPicture upright(DecodedPicture picture);

}  // namespace lippmann
