#include "job/param_text.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/math.hpp"

namespace lippmann {
namespace {

template <class T>
Extent<T> parse_extent(std::string_view text, T lowest, T highest, const std::string& where) {
  const std::size_t cross = text.find('x');
  const std::optional<T> x = parse_number<T>(text.substr(0, cross));
  const std::optional<T> y = cross == std::string_view::npos ? T{0} : parse_number<T>(text.substr(cross + 1));
  const auto fits = [&](T value) { return value >= lowest && value <= highest; };
  const bool is_read = x && y;
  if (!is_read || !fits(*x) || (cross != std::string_view::npos && !fits(*y)))
    throw usage_error(where,
                      is_read ? fmt::format("'{}' is out of range", text) : fmt::format("cannot read '{}' as a size", text),
                      fmt::format("N or NxM, each from {} to {}", lowest, highest));
  return {*x, *y};
}

template <class T>
std::string format_extent(const Extent<T>& extent) {
  return extent.y == 0 ? fmt::format("{}", extent.x) : fmt::format("{}x{}", extent.x, extent.y);
}

}  // namespace

bool read_flag(std::string_view text, const std::string& where) {
  if (text != "true" && text != "false")
    throw usage_error(where, fmt::format("'{}' is not true or false", text), "true or false");
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

std::optional<float> read_distance(std::string_view text, const std::string& where) {
  if (text == "auto") return std::nullopt;
  if (text == "inf") return kInfinity;
  const auto value = parse_number<float>(text);
  if (!value || !(*value > 0.0f) || !std::isfinite(*value))
    throw usage_error(where, fmt::format("'{}' is not a distance", text), "millimetres above 0, inf, or auto");
  return *value;
}

std::string write_distance(std::optional<float> distance_mm) { return distance_mm ? fmt::format("{}", *distance_mm) : "auto"; }

EyeHeight read_eye_height(std::string_view text, const std::string& where) {
  constexpr std::string_view kDegrees = "deg";
  constexpr float kMaxDegrees = 80.0f, kMaxMm = 1e6f;
  const bool is_angle = text.ends_with(kDegrees);
  const auto value = parse_number<float>(is_angle ? text.substr(0, text.size() - kDegrees.size()) : text);
  if (!value || !(std::abs(*value) <= (is_angle ? kMaxDegrees : kMaxMm)))
    throw usage_error(where, fmt::format("cannot read '{}' as the height of an eye", text),
                      "millimetres above the middle of the display, such as 150, or degrees from -80 to 80, such as 30deg");
  return {*value, is_angle};
}

std::string write_eye_height(const EyeHeight& height) {
  return fmt::format("{}{}", height.value, height.is_angle ? "deg" : "");
}

DepthRange read_depth_range(std::string_view text, const std::string& where) {
  const std::size_t colon = text.find(':');
  const auto near = parse_number<double>(text.substr(0, colon));
  const auto far = colon == std::string_view::npos ? std::nullopt : parse_number<double>(text.substr(colon + 1));
  if (!near || !far || !(*far < *near && *near - *far < 1e9))
    throw usage_error(where, fmt::format("cannot read '{}' as a range of depths", text),
                      "NEAR:FAR in mm, above 0 in front of the screen, such as 10:-30");
  return {*near, *far};
}

std::size_t read_choice(std::string_view text, std::span<const std::string_view> names, const std::string& where) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return i;
  throw usage_error(where, fmt::format("there is no '{}'{}", text, did_you_mean(text, names)),
                    fmt::format("{}", fmt::join(names, ", ")));
}

}  // namespace lippmann
