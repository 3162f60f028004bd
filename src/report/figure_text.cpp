#include "report/figure_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "job/size_estimate.hpp"

namespace lippmann {
namespace {

std::string three_digits(double value) {
  const int digits = value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
  return fmt::format("{:.{}f}", value, digits);
}

std::string two_units(long long whole, long long per, const char* large, const char* small) {
  return fmt::format("{} {} {} {}", whole / per, large, whole % per, small);
}

}  // namespace

std::string seconds_text(double seconds) {
  if (seconds < 0.9995) return three_digits(1e3 * seconds) + " ms";
  if (seconds < 99.95) return three_digits(seconds) + " s";
  const long long whole = std::llround(seconds);
  return whole < 3600 ? two_units(whole, 60, "min", "s") : two_units((whole + 30) / 60, 60, "h", "min");
}

std::string percent_text(std::optional<double> share) {
  return share ? fmt::format("{:.1f} %", 100.0 * *share) : std::string(kNotKnown);
}

std::string decibel_text(std::optional<double> decibels) {
  return decibels ? fmt::format("{:.2f} dB", *decibels) : std::string(kNotKnown);
}

std::string count_text(double count) {
  if (count < 1e4) return fmt::format("{:.0f}", count);
  if (count < 999.5e3) return three_digits(count * 1e-3) + " k";
  return count < 999.5e6 ? three_digits(count * 1e-6) + " M" : three_digits(count * 1e-9) + " G";
}

std::string memory_text(double bytes) { return bytes > 0.0 ? bytes_text(bytes) : std::string(kNotKnown); }

}  // namespace lippmann
