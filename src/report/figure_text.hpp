// Formats numbers for the user, with three digits and a suitable unit. An unknown number becomes a dash.
#pragma once

#include <optional>
#include <string>

namespace lippmann {

inline constexpr const char* kNotKnown = "–";

std::string seconds_text(double seconds);                  ///< for example "12.3 ms", "1.50 s", "2 min 5 s", "3 h 12 min"
std::string percent_text(std::optional<double> share);     ///< 0.123 becomes "12.3 %"
std::string decibel_text(std::optional<double> decibels);  ///< for example "34.50 dB"
std::string count_text(double count);                      ///< for example "950", "12.3 k", "1.25 M"
/// 0 means that the memory was not recorded, and becomes a dash.
std::string memory_text(double bytes);

}  // namespace lippmann
