// Bytes as text: base 64 (RFC 4648, section 4), for pages that hold their pictures.
#pragma once

#include <string>
#include <string_view>

namespace lippmann {

/// With '=' at the end, so that the length is a multiple of four.
std::string base64(std::string_view bytes);

}  // namespace lippmann
