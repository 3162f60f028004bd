// Reads text files whole, within a limit.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace lippmann {

/// The contents of a regular file. Throws Error at `where` if it cannot be read or is larger than `limit_bytes`; `accepted`
/// says what is not too large.
std::string read_text_file(const std::filesystem::path& file, const std::string& where, std::size_t limit_bytes,
                           const std::string& accepted);

}  // namespace lippmann
