#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace lippmann::test {

std::string big_endian(std::uint32_t value, int size = 4);

using Primaries = std::array<std::array<double, 3>, 3>;
inline constexpr Primaries kSrgbPrimaries{{{0.4361, 0.2225, 0.0139}, {0.3851, 0.7169, 0.0971}, {0.1431, 0.0606, 0.7139}}};
inline constexpr Primaries kP3Primaries{{{0.5151, 0.2412, -0.0011}, {0.2920, 0.6922, 0.0419}, {0.1571, 0.0666, 0.7841}}};

std::string profile_with(const Primaries& primaries, double gamma);

/// Returns a CMYK profile in which paper is white and any ink at full strength is black. From Lab, every colour becomes
/// grey, printed with 1 - L* / 100 of black ink.
std::string press_profile();

}  // namespace lippmann::test
