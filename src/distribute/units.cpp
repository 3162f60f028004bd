#include "distribute/units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/number_text.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

Unit read_unit(std::string_view text, const std::string& where) {
  constexpr int kMost = 1'000'000;
  const std::size_t slash = text.find('/');
  const std::optional<int> index = parse_number<int>(text.substr(0, slash));
  const std::optional<int> count = slash == std::string_view::npos ? std::nullopt : parse_number<int>(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count || *count > kMost)
    throw usage_error(where, fmt::format("'{}' is no unit", text),
                      fmt::format("I/N with 1 <= I <= N <= {}, such as 7/200", kMost));
  return {*index, *count};
}

std::string write_unit(const Unit& unit) { return fmt::format("{}/{}", unit.index, unit.count); }

std::vector<std::vector<int>> units_of(const std::vector<int>& frames, int segment, int count) {
  std::vector<std::vector<int>> segments;
  for (const int frame : frames) {
    if (segments.empty() || segments.back().back() / segment != frame / segment) segments.emplace_back();
    segments.back().push_back(frame);
  }
  const auto parts = std::min<std::size_t>(static_cast<std::size_t>(count), segments.size());
  std::vector<std::vector<int>> units(parts);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    std::vector<int>& unit = units[i * parts / segments.size()];
    unit.insert(unit.end(), segments[i].begin(), segments[i].end());
  }
  return units;
}

std::vector<int> frames_of(const Unit& unit, const std::vector<int>& frames, int segment) {
  const std::vector<std::vector<int>> units = units_of(frames, segment, unit.count);
  const auto index = static_cast<std::size_t>(unit.index - 1);
  return index < units.size() ? units[index] : std::vector<int>();
}

}  // namespace lippmann
