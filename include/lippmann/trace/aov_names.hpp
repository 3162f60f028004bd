// What flags, files and other programs call the layers of a frame.
#pragma once

#include <array>
#include <string_view>

#include "lippmann/trace/aovs.hpp"

namespace lippmann {

/// By Aov.
inline constexpr std::array<std::string_view, kAovs> kAovNames{"depth",  "normal", "id",     "position", "ray-depth",
                                                               "albedo", "motion", "direct", "indirect", "alpha"};

}  // namespace lippmann
