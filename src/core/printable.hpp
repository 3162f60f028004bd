// Makes text of foreign origin (a file's contents, a name) fit to stand in a message.
#pragma once

#include <string>
#include <string_view>

namespace lippmann {

/// The first 60 characters of UTF-8 text, then "..." if there are more; control characters, those that turn the direction of
/// text, and bytes that are not UTF-8 become '?'.
std::string printable(std::string_view text);

/// All of the text, with the same characters replaced: one line of a message, with names that it got from files. Error and the
/// tool's warnings pass through it.
std::string printable_line(std::string_view text);

/// The first 60 characters in single quotes.
std::string shown(std::string_view text);

/// One word of a command that can be pasted into a shell: as it is where the shell gives no meaning to any of its characters,
/// else quoted. Not shortened.
std::string shell_word(std::string_view text);

}  // namespace lippmann
