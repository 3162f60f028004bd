#include "core/number_text.hpp"

#include <fmt/core.h>

#include "lippmann/core/error.hpp"

namespace lippmann {

std::int64_t read_integer(std::string_view text, std::int64_t lowest, std::int64_t highest, const std::string& where) {
  const auto value = parse_number<std::int64_t>(text);
  if (!value || *value < lowest || *value > highest)
    throw usage_error(where, fmt::format("'{}' is not a whole number in this range", text),
                      fmt::format("a whole number from {} to {}", lowest, highest));
  return *value;
}

std::optional<int> read_integer_or_auto(std::string_view text, int lowest, int highest, const std::string& where) {
  if (text == "auto") return std::nullopt;
  const auto value = parse_number<int>(text);
  if (!value || *value < lowest || *value > highest)
    throw usage_error(where, fmt::format("'{}' is neither auto nor a whole number in range", text),
                      fmt::format("auto, or a whole number from {} to {}", lowest, highest));
  return value;
}

double read_number(std::string_view text, double lowest, double highest, const std::string& where) {
  const auto value = parse_number<double>(text);
  if (!value || !(*value >= lowest && *value <= highest))
    throw usage_error(where, fmt::format("'{}' is not a number in this range", text),
                      fmt::format("a number from {} to {}", lowest, highest));
  return *value;
}

}  // namespace lippmann
