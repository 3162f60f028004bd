#include "formats/lfp_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kHeaderBytes = 16, kNameBytes = 80;
constexpr std::string_view kMagicEnd = "\r\n\x1a\n";

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool begins_section(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderBytes || bytes[0] != std::byte{0x89}) return false;
  const std::string_view text = text_of(bytes);
  return text.substr(1, 2) == "LF" && text.substr(4, 4) == kMagicEnd;
}

std::size_t big_endian(std::span<const std::byte> four) {
  std::size_t value = 0;
  for (const std::byte byte : four) value = value * 256 + std::to_integer<std::size_t>(byte);
  return value;
}

}  // namespace

bool is_lfp(std::span<const std::byte> file) { return begins_section(file) && text_of(file)[3] == 'P'; }

std::vector<LfpSection> lfp_sections(std::span<const std::byte> file, const std::string& where) {
  std::vector<LfpSection> sections;
  std::size_t at = 0;
  while (at < file.size()) {
    if (file[at] == std::byte{0}) {
      ++at;
      continue;
    }
    const std::span<const std::byte> rest = file.subspan(at);
    if (!begins_section(rest))
      throw Error(where, fmt::format("has no valid section at byte {}", at), "an .lfp or .lfr file of Lytro");
    const std::size_t length = big_endian(rest.subspan(12, 4));
    at += kHeaderBytes;
    if (length == 0) continue;
    if (rest.size() < kHeaderBytes + kNameBytes + length)
      throw Error(where, fmt::format("is truncated: a section of {} bytes begins at byte {} of {}", length, at, file.size()),
                  "a whole file");
    const std::string_view name = text_of(rest.subspan(kHeaderBytes, kNameBytes));
    sections.push_back({std::string(text_of(rest.subspan(1, 3))), std::string(name.substr(0, name.find('\0'))),
                        rest.subspan(kHeaderBytes + kNameBytes, length)});
    at += kNameBytes + length;
  }
  return sections;
}

const LfpSection& lfp_section(const std::vector<LfpSection>& sections, const std::string& name, const std::string& where) {
  const auto found =
      std::find_if(sections.begin(), sections.end(), [&](const LfpSection& section) { return section.name == name; });
  if (found == sections.end())
    throw Error(where, "its document refers to the section " + shown(name) + ", which is missing", "a whole file");
  return *found;
}

}  // namespace lippmann
