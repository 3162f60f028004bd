// Checks the headers and chunks of an OpenEXR file before OpenEXR reads them. Private to src/image.
//
// OpenEXR allocates memory by the sizes in a header before it reads the data, so a file of a hundred bytes can make it allocate
// gigabytes. Some versions of OpenEXR read a truncated file as if zeros followed.
#pragma once

#include <OpenEXR/ImfCompression.h>

#include <cstdint>
#include <string>

#include "image/decode.hpp"

namespace lippmann {

/// Throws Error unless the file contains the values of all attributes with the size of their type, pictures are within the
/// limits, and the file contains all chunks completely. Call Imf::staticInitialize() before.
void check_exr_file(FileBytes file, const std::string& where);

/// Returns the number of scan lines in a chunk with this compression.
std::uint64_t exr_lines_per_chunk(Imf::Compression compression);

}  // namespace lippmann
