// The orientation in EXIF data, which JPEG, PNG and WebP files carry. Private to src/image.
#pragma once

#include "image/decode.hpp"

namespace lippmann {

/// Returns the orientation, or upright if it is missing or the data are damaged. exif: begins with the byte order mark of its
/// TIFF header, or with "Exif\0\0" before it.
Orientation exif_orientation(FileBytes exif);

}  // namespace lippmann
