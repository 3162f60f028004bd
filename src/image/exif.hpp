// The orientation in EXIF data, which JPEG, PNG and WebP files carry. Private to src/image.
#pragma once

#include "image/decode.hpp"

namespace lippmann {

/// `exif` begins with the byte order mark of its TIFF header, or with "Exif\0\0" before it. Upright where nothing else is said,
/// or the data are damaged.
Orientation exif_orientation(FileBytes exif);

}  // namespace lippmann
