// Base 64 encoding (RFC 4648, section 4), for pages with embedded images.
#pragma once

#include <string>
#include <string_view>

namespace lippmann {

/// Encodes bytes, with '=' padding to a multiple of four characters.
std::string base64(std::string_view bytes);

}  // namespace lippmann
