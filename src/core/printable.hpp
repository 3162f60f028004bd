#pragma once

#include <string>
#include <string_view>

namespace lippmann {

/// Returns the first 60 characters of UTF-8 text, followed by "..." if there are more. Control characters, characters that
/// change the text direction, and bytes that are not UTF-8 become '?'.
std::string printable(std::string_view text);

/// Returns the whole text as one line, with the same replacements as printable().
std::string printable_line(std::string_view text);

/// Returns the first 60 characters as printable() does, in single quotes.
std::string shown(std::string_view text);

/// Returns the text as one word of a shell command: unchanged if no character is special to the shell, otherwise quoted.
std::string shell_word(std::string_view text);

}  // namespace lippmann
