// Looks at an OpenEXR file's headers and chunks before OpenEXR does. Private to src/image.
//
// OpenEXR makes room for what an attribute says that it has, and for a place of every chunk, before it reads either: some
// hundred bytes can make it allocate gigabytes. Some versions of it read a file that is cut off as if zeros followed.
#pragma once

#include <OpenEXR/ImfCompression.h>

#include <cstdint>
#include <string>

#include "image/decode.hpp"

namespace lippmann {

/// Throws Error unless the values of all attributes are in the file and have the size of their type, pictures are within the
/// limits, and the file has all of their chunks to the last byte. Imf::staticInitialize() comes first.
void check_exr_file(FileBytes file, const std::string& where);

/// How many scan lines are compressed together.
std::uint64_t exr_lines_per_chunk(Imf::Compression compression);

}  // namespace lippmann
