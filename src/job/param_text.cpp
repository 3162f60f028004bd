#include "job/param_text.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

template <class T>
Extent<T> parse_extent(std::string_view text, T lowest, T highest, const std::string& where) {
  const std::size_t cross = text.find('x');
  const std::optional<T> x = parse_number<T>(text.substr(0, cross));
  const std::optional<T> y = cross == std::string_view::npos ? T{0} : parse_number<T>(text.substr(cross + 1));
  const auto fits = [&](T value) { return value >= lowest && value <= highest; };
  if (!x || !y || !fits(*x) || (cross != std::string_view::npos && !fits(*y)))
    throw usage_error(where, fmt::format("'{}' is not a size in this range", text),
                      fmt::format("N or NxM, each from {} to {}", lowest, highest));
  return {*x, *y};
}

/// A, A-B or A-B:S.
std::optional<FrameRange> parse_range(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view ends = text.substr(0, colon);
  const std::size_t dash = ends.find('-');
  const auto first = parse_number<int>(ends.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parse_number<int>(ends.substr(dash + 1));
  const auto step = colon == std::string_view::npos ? 1 : parse_number<int>(text.substr(colon + 1));
  if (!first || !last || !step || *first < 0 || *last < *first || *step < 1) return std::nullopt;
  return FrameRange{*first, *last, *step};
}

template <class T>
std::string format_extent(const Extent<T>& extent) {
  return extent.y == 0 ? fmt::format("{}", extent.x) : fmt::format("{}x{}", extent.x, extent.y);
}

}  // namespace

bool read_flag(std::string_view text, const std::string& where) {
  if (text != "true" && text != "false")
    throw usage_error(where, fmt::format("'{}' is neither true nor false", text), "true or false");
  return text == "true";
}

Extent<int> read_extent(std::string_view text, int lowest, int highest, const std::string& where) {
  return parse_extent<int>(text, lowest, highest, where);
}
Extent<float> read_extent(std::string_view text, float lowest, float highest, const std::string& where) {
  return parse_extent<float>(text, lowest, highest, where);
}
std::string write_extent(const Extent<int>& extent) { return format_extent(extent); }
std::string write_extent(const Extent<float>& extent) { return format_extent(extent); }

FrameRanges read_frames(std::string_view text, const std::string& where) {
  constexpr std::int64_t kMost = 10'000'000;
  std::int64_t count = 0;
  FrameRanges ranges;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    const std::optional<FrameRange> range = parse_range(text.substr(start, comma - start));
    if (!range)
      throw usage_error(where, fmt::format("'{}' does not say which frames", text),
                        "A-B with 0 <= A <= B, one frame A, every S-th as A-B:S, or several of these: 0,2,4-8,10-20:5");
    count += (std::int64_t{range->last} - range->first) / range->step + 1;
    if (count > kMost)
      throw usage_error(where, fmt::format("'{}' are too many frames", text), fmt::format("at most {}", kMost));
    ranges.push_back(*range);
    start = comma + 1;
  }
  return ranges;
}

std::string write_frames(const FrameRanges& frames) {
  std::string text;
  for (const FrameRange& range : frames) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", range.first);
    if (range.last != range.first) text += fmt::format("-{}", range.last);
    if (range.step != 1) text += fmt::format(":{}", range.step);
  }
  return text;
}

std::optional<float> read_distance(std::string_view text, const std::string& where) {
  if (text == "auto") return std::nullopt;
  if (text == "inf") return kInfinity;
  const auto value = parse_number<float>(text);
  if (!value || !(*value > 0.0f) || !std::isfinite(*value))
    throw usage_error(where, fmt::format("'{}' is not a distance", text), "millimetres above 0, inf, or auto");
  return *value;
}

std::string write_distance(std::optional<float> distance_mm) { return distance_mm ? fmt::format("{}", *distance_mm) : "auto"; }

std::size_t read_choice(std::string_view text, std::span<const std::string_view> names, const std::string& where) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return i;
  throw usage_error(where, fmt::format("there is no '{}'{}", text, did_you_mean(text, names)),
                    fmt::format("{}", fmt::join(names, ", ")));
}

}  // namespace lippmann
