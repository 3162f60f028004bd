// Turns pictures upright that a camera or a scanner has stored turned or mirrored. Private to src/image.
#pragma once

#include "image/decode.hpp"

namespace lippmann {

/// EXIF's and TIFF's number; what is not 1 to 8 is upright.
Orientation orientation_of(unsigned number);

/// The header of the upright picture: width and height change places if rows become columns.
PictureHeader upright(PictureHeader header);
DecodedPicture upright(DecodedPicture picture);

}  // namespace lippmann
