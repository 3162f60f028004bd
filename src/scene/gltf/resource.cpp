// Based on: RFC 2397 (data URIs), RFC 3986 section 2.1 (percent-encoding), RFC 4648 section 4 (base 64).
#include "scene/gltf/resource.hpp"

#include <array>
#include <cstdint>
#include <optional>

#include "scene/gltf/container.hpp"

namespace lippmann::gltf {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<int, 256> make_digits() {
  std::array<int, 256> digits{};
  for (int& digit : digits) digit = -1;
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) digits[static_cast<unsigned char>(kAlphabet[i])] = static_cast<int>(i);
  return digits;
}
constexpr std::array<int, 256> kDigits = make_digits();

std::optional<std::vector<std::byte>> decode_base64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = kDigits[static_cast<unsigned char>(c)];
    if (digit < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> count));
  }
  return bytes;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percent_decode(std::string_view uri) {
  std::string result;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escape = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
    result += escape ? static_cast<char>(16 * hex_digit(uri[i + 1]) + hex_digit(uri[i + 2])) : uri[i];
    if (escape) i += 2;
  }
  return result;
}

bool is_address(const std::string& name) { return name.find("://") != std::string::npos; }

std::vector<std::byte> decode_data_uri(std::string_view uri, std::string_view element, const Report& report) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
    report.fail(element, "the data URI is not base64");
  std::optional<std::vector<std::byte>> bytes = decode_base64(uri.substr(comma + 1));
  if (!bytes) report.fail(element, "the data URI is not valid base64");
  return std::move(*bytes);
}

}  // namespace

std::string uri_problem(std::string_view uri, const SideFolders& folders, const std::string& where) {
  if (uri.starts_with("data:")) return {};
  const std::string name = percent_decode(uri);
  if (is_address(name)) return shown(name) + " is a network address";
  return find_side_file(folders, name, where).problem;
}

std::vector<std::byte> fetch(std::string_view uri, const SideFolders& folders, std::uint64_t limit, std::string_view element,
                             const Report& report) {
  if (uri.starts_with("data:")) return decode_data_uri(uri, element, report);
  const std::string name = percent_decode(uri);
  if (is_address(name)) report.fail(element, shown(name) + " is a network address", "a file in or below the scene's folder");
  return read_file(side_file(folders, name, report.where(element)), limit, element, report);
}

}  // namespace lippmann::gltf
