#include "distribute/units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/frame_ranges.hpp"
#include "core/number_text.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

Units read_units(std::string_view text, const std::string& where) {
  constexpr int kMost = 1'000'000;
  const std::size_t slash = text.find('/');
  const std::optional<int> count = slash == std::string_view::npos ? std::nullopt : parse_number<int>(text.substr(slash + 1));
  const auto problem = [&] {
    return usage_error(where, fmt::format("'{}' is not a unit", text),
                       fmt::format("I/N with 1 <= I <= N <= {}, such as 7/200, or several as in 1-3,5/200", kMost));
  };
  if (!count || *count < 1 || *count > kMost) throw problem();
  Units units{{}, *count};
  try {
    units.indices = frames_of(read_frames(text.substr(0, slash), where));
  } catch (const Error&) {
    throw problem();
  }
  if (units.indices.front() < 1 || units.indices.back() > *count) throw problem();
  return units;
}

std::string write_units(const Units& units) {
  return fmt::format("{}/{}", write_frames(ranges_of(units.indices)), units.count);
}

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

std::vector<int> frames_of(const Units& units, const std::vector<int>& frames, int segment) {
  const std::vector<std::vector<int>> all = units_of(frames, segment, units.count);
  std::vector<int> of_these;
  for (const int index : units.indices) {
    if (static_cast<std::size_t>(index) > all.size()) break;
    const std::vector<int>& unit = all[static_cast<std::size_t>(index - 1)];
    of_these.insert(of_these.end(), unit.begin(), unit.end());
  }
  return of_these;
}

}  // namespace lippmann
