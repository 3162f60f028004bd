// Turns images upright that a camera or a scanner stored rotated or mirrored. Private to src/image.
#pragma once

#include "image/decode.hpp"

namespace lippmann {

/// Returns the orientation of an EXIF or TIFF number. Numbers outside 1 to 8 are upright.
Orientation orientation_of(unsigned number);

/// Returns the upright image or its header. Width and height are swapped if rows become columns.
PictureHeader upright(PictureHeader header);
DecodedPicture upright(DecodedPicture picture);

}  // namespace lippmann
