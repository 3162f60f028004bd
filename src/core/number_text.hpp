#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lippmann {

/// Returns the number if the whole text is a number, otherwise nothing. Returns 0 for -0, because a job file (TOML) would not
/// preserve the sign.
template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc() || stop != end) return std::nullopt;
  return value == T{} ? T{} : value;
}

/// Parses an integer from lowest to highest. Throws a usage Error at `where` with the accepted range.
std::int64_t read_integer(std::string_view text, std::int64_t lowest, std::int64_t highest, const std::string& where);

/// Same as read_integer(); returns nothing for "auto".
std::optional<int> read_integer_or_auto(std::string_view text, int lowest, int highest, const std::string& where);

/// Parses a finite number from lowest to highest. Throws a usage Error at `where` with the accepted range.
double read_number(std::string_view text, double lowest, double highest, const std::string& where);

}  // namespace lippmann
