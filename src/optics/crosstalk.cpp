#include "lippmann/optics/crosstalk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "lippmann/core/error.hpp"
#include "optics/model.hpp"

namespace lippmann {
namespace {

constexpr double kMaxPercent = 23.0;

/// Returns the sigma in pixels for which neighbour_share() is `share`. neighbour_share() increases up to a sigma of 0.9 pixels,
/// where it is 0.238.
double sigma_of_share(double share) {
  double low = 0.0, high = 0.9;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (neighbour_share(middle) < share ? low : high) = middle;
  }
  return share > 0.0 ? 0.5 * (low + high) : 0.0;
}

}  // namespace

Taps gaussian_taps(double position_px, double sigma_px) {
  Taps taps;
  const int first = static_cast<int>(std::floor(position_px - 4.0 * sigma_px));
  const int last = static_cast<int>(std::floor(position_px + 4.0 * sigma_px));
  const double scale = std::numbers::sqrt2 / 2.0 / sigma_px;
  double below = std::erf((first - position_px) * scale);
  for (int i = first; i <= last; ++i) {
    const double upto = std::erf((i + 1 - position_px) * scale);
    taps.add(i, 0.5 * (upto - below));
    below = upto;
  }
  return taps;
}

Vec2d crosstalk_sigmas(const Optics& optics, double sigma_px) {
  const OpticsFacts facts = optics_facts(optics);
  const auto along = [&](double pitch) {
    if (!(pitch > 0.0)) return 0.0;
    return pitch == 1.0 ? sigma_px : std::min(sigma_px / pitch, kMaxBlurPx);
  };
  return {along(facts.crosstalk_pitch.x), along(facts.crosstalk_pitch.y)};
}

double neighbour_share(double sigma_px) {
  if (!(sigma_px > 0.0)) return 0.0;
  const auto below = [&](double x) { return 0.5 * std::erf(x / (std::numbers::sqrt2 * sigma_px)); };
  return below(1.5) - below(0.5);
}

double read_crosstalk(std::string_view text, const std::string& where) {
  double value = -1.0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  const bool percent = read.ec == std::errc() && read.ptr + 1 == end && *read.ptr == '%';
  const bool whole = read.ec == std::errc() && (percent || read.ptr == end);
  if (!whole || !(value >= 0.0 && value <= (percent ? kMaxPercent : kMaxBlurPx)))
    throw usage_error(
        where, fmt::format("'{}' is not a crosstalk value", text),
        fmt::format("a sigma from 0 to {} pixels, or the weight of each neighbour, 0% to {}%", kMaxBlurPx, kMaxPercent));
  return percent ? sigma_of_share(0.01 * value) : value;
}

}  // namespace lippmann
