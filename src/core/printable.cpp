#include "core/printable.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace lippmann {
namespace {

/// Returns the length in bytes of the first character of `text`, or 0 if it is not printable: not UTF-8, a control character, a
/// line separator, or a character that changes the text direction.
std::size_t character_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  if (byte(0) < 0x80) return byte(0) < 0x20 || byte(0) == 0x7f ? 0 : 1;
  const std::size_t length = byte(0) >= 0xf0 && byte(0) <= 0xf4  ? 4
                             : byte(0) >= 0xe0 && byte(0) < 0xf0 ? 3
                             : byte(0) >= 0xc2 && byte(0) < 0xe0 ? 2
                                                                 : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool is_control = byte(0) == 0xc2 && byte(1) < 0xa0;  // U+0080 to U+009F
  const bool turns_text = length == 3 && byte(0) == 0xe2 &&
                          ((byte(1) == 0x80 && byte(2) >= 0xa8 && byte(2) <= 0xae) ||  // U+2028 to U+202E
                           (byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9));   // U+2066 to U+2069
  return is_control || turns_text ? 0 : length;
}

void move_character(std::string_view& text, std::string& line) {
  const std::size_t bytes = character_bytes(text);
  line += bytes ? text.substr(0, bytes) : "?";
  text.remove_prefix(bytes ? bytes : 1);
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr int kLongest = 60;
  std::string result;
  for (int count = 0; !text.empty(); ++count) {
    if (count == kLongest) return result + "...";
    move_character(text, result);
  }
  return result;
}

std::string printable_line(std::string_view text) {
  std::string result;
  while (!text.empty()) move_character(text, result);
  return result;
}

std::string shown(std::string_view text) { return fmt::format("'{}'", printable(text)); }

std::string shell_word(std::string_view text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,:=@%+-";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos) return std::string(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace lippmann
