// Reads the orientation from the EXIF data of JPEG, PNG and WebP files. Private to src/image.
#pragma once

#include "image/decode.hpp"

namespace lippmann {

/// Returns kUpright if the orientation is missing or damaged. `exif` begins with a TIFF header, or with "Exif\0\0" before it.
Orientation exif_orientation(FileBytes exif);

}  // namespace lippmann
