// Reads text files whole, within a limit, and in any of the encodings that they come in.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace lippmann {

/// The contents of a regular file. Throws Error at `where` if it cannot be read or is larger than `limit_bytes`; `accepted`
/// says what is not too large.
std::string read_text_file(const std::filesystem::path& file, const std::string& where, std::size_t limit_bytes,
                           const std::string& accepted);

/// The text as UTF-8 without a byte order mark. UTF-16 is known by its mark, or where there is none by the zero half of an
/// ASCII character at its beginning; anything else is returned as it is. Halves that are no characters become U+FFFD.
std::string utf8_text(std::string text);

}  // namespace lippmann
