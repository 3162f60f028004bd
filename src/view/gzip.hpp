// Compresses the texts of the page.
#pragma once

#include <string>
#include <string_view>

namespace lippmann {

/// Returns `text` as a gzip file (RFC 1952), the content coding "gzip" of HTTP.
std::string gzip(std::string_view text);

}  // namespace lippmann
