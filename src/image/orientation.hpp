// Turns images upright whose samples a camera or a scanner stored rotated or mirrored. Private to src/image.
#pragma once

#include "image/decode.hpp"

namespace lippmann {

/// Returns the orientation with this number in EXIF or TIFF. For numbers outside 1 to 8, returns kUpright.
Orientation orientation_of(unsigned number);

/// Return the upright image, or its header. Width and height are exchanged if rows become columns.
PictureHeader upright(PictureHeader header);
DecodedPicture upright(DecodedPicture picture);

}  // namespace lippmann
