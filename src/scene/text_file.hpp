#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace lippmann {

/// Returns the contents of a regular file. Throws Error at `where` if it cannot be read or is larger than `limit_bytes`.
/// `accepted` describes this limit.
std::string read_text_file(const std::filesystem::path& file, const std::string& where, std::size_t limit_bytes,
                           const std::string& accepted);

/// Converts text to UTF-8 without a byte order mark. UTF-16 is detected by its byte order mark, or by a zero byte next to the
/// first character. Unpaired surrogates become U+FFFD.
std::string utf8_text(std::string text);

}  // namespace lippmann
