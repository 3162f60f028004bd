// Numbers as text, in a range.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lippmann {

/// The number that `text` is, whole; none for anything else around it. -0 is 0: written as TOML it would be a whole number,
/// which knows no sign.
template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc() || stop != end) return std::nullopt;
  return value == T{} ? T{} : value;
}

/// A whole number, lowest ... highest. Throws a usage Error at `where` that says what would be accepted.
std::int64_t read_integer(std::string_view text, std::int64_t lowest, std::int64_t highest, const std::string& where);

/// The same, or "auto" (none).
std::optional<int> read_integer_or_auto(std::string_view text, int lowest, int highest, const std::string& where);

/// A finite number, lowest ... highest. Throws likewise.
double read_number(std::string_view text, double lowest, double highest, const std::string& where);

}  // namespace lippmann
