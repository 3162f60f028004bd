// Turns images upright that a camera or a scanner stored rotated or mirrored. Private to src/image.
#pragma once

#include "image/decode.hpp"

namespace lippmann {

/// Returns the orientation for a number from EXIF or TIFF. Returns kUpright for numbers outside 1 to 8.
Orientation orientation_of(unsigned number);

/// Return the header of the upright image, or the upright image. Width and height are exchanged if rows become columns.
PictureHeader upright(PictureHeader header);
DecodedPicture upright(DecodedPicture picture);

}  // namespace lippmann
