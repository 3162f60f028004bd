// Which light is computed, and how.
#pragma once

#include <array>
#include <string_view>

namespace lippmann {

/// How light is computed.
enum class Integrator {
  kWhitted,  ///< direct light, sharp shadows, mirrors, refraction
  kPath,     ///< all of it, by random paths
};

/// What flags and job files call them, in the order of Integrator.
inline constexpr std::array<std::string_view, 2> kIntegratorNames{"whitted", "path"};

}  // namespace lippmann
