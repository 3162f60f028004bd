// The orientation in EXIF data, which JPEG, PNG and WebP files carry. Private to src/image.
#pragma once

#include "image/decode.hpp"

namespace lippmann {

/// Returns the orientation, or kUpright if it is missing or the data are damaged. `exif` begins with a TIFF header or with
/// "Exif\0\0" and a TIFF header.
Orientation exif_orientation(FileBytes exif);

}  // namespace lippmann
