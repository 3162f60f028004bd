#include "scene/text_file.hpp"

#include <string_view>

#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

namespace fs = std::filesystem;

namespace {

void append_utf8(std::string& text, char32_t c) {
  const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
  const auto tail = [&](int shift) { add(0x80 | (c >> shift & 0x3f)); };
  if (c < 0x80)
    add(c);
  else if (c < 0x800)
    add(0xc0 | c >> 6), tail(0);
  else if (c < 0x10000)
    add(0xe0 | c >> 12), tail(6), tail(0);
  else
    add(0xf0 | c >> 18), tail(12), tail(6), tail(0);
}

/// Converts UTF-16 to UTF-8. `low` is the index of the low byte in each pair of bytes: 0 for little-endian text, 1 for
/// big-endian.
std::string from_utf16(std::string_view bytes, std::size_t low) {
  constexpr char32_t kReplacement = 0xfffd;
  const auto unit = [&](std::size_t i) {
    const auto byte = [&](std::size_t k) { return static_cast<char32_t>(static_cast<unsigned char>(bytes[2 * i + k])); };
    return byte(low) | byte(1 - low) << 8;
  };
  const std::size_t count = bytes.size() / 2;
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    const char32_t c = unit(i);
    const bool high_half = c >= 0xd800 && c < 0xdc00, low_half = c >= 0xdc00 && c < 0xe000;
    const char32_t next = high_half && i + 1 < count ? unit(i + 1) : 0;
    if (next >= 0xdc00 && next < 0xe000)
      append_utf8(text, 0x10000 + ((c - 0xd800) << 10) + (next - 0xdc00)), ++i;
    else
      append_utf8(text, high_half || low_half ? kReplacement : c);
  }
  return text;
}

}  // namespace

std::string utf8_text(std::string text) {
  const std::string_view bytes(text);
  if (bytes.starts_with("\xef\xbb\xbf")) return text.substr(3);
  if (bytes.starts_with("\xff\xfe")) return from_utf16(bytes.substr(2), 0);
  if (bytes.starts_with("\xfe\xff")) return from_utf16(bytes.substr(2), 1);
  if (bytes.size() < 2 || (bytes[0] == '\0') == (bytes[1] == '\0')) return text;
  return from_utf16(bytes, bytes[0] == '\0' ? 1 : 0);
}

std::string read_text_file(const fs::path& file, const std::string& where, std::size_t limit_bytes,
                           const std::string& accepted) {
  RegularFile opened(file);
  const std::string named = where == file.string() ? "" : file.string() + " ";  // avoids a message that names the file twice
  if (!opened.problem().empty()) throw Error(where, named + opened.problem());
  if (opened.size() > limit_bytes) throw Error(where, "the scene's files are too large", accepted);
  std::string text(static_cast<std::size_t>(opened.size()), '\0');
  if (opened.read(text.data(), text.size()) < text.size()) throw Error(where, named + "cannot be read completely");
  return text;
}

}  // namespace lippmann
