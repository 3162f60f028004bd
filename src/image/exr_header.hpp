// Checks the headers and chunks of an OpenEXR file before OpenEXR reads them. Private to src/image.
//
// OpenEXR allocates memory by the header before it reads the data, so a file of a hundred bytes can cause an allocation of
// gigabytes.
#pragma once

#include <OpenEXR/ImfCompression.h>

#include <cstdint>
#include <string>

#include "image/decode.hpp"

namespace lippmann {

/// Throws Error unless all of these are true:
/// 1. The file contains the values of all attributes, and each value has the size that its type requires.
/// 2. Pictures are within the limits of limits.hpp.
/// 3. The file contains all chunks completely.
/// Call Imf::staticInitialize() before.
void check_exr_file(FileBytes file, const std::string& where);

std::uint64_t exr_lines_per_chunk(Imf::Compression compression);

}  // namespace lippmann
