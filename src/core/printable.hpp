// Makes text of foreign origin (a file's contents, a name) fit to stand in a message.
#pragma once

#include <string>
#include <string_view>

namespace lippmann {

/// The first 60 characters of UTF-8 text, then "..." if there are more; control characters and bytes that are not UTF-8 become
/// '?'.
std::string printable(std::string_view text);

/// The same in single quotes.
std::string shown(std::string_view text);

/// One word of a command that can be pasted into a shell: as it is where the shell gives no meaning to any of its characters,
/// else quoted. Not shortened.
std::string shell_word(std::string_view text);

}  // namespace lippmann
