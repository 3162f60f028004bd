// Which light is computed, and how.
#pragma once

namespace lippmann {

/// How light is computed.
enum class Integrator {
  kWhitted,  ///< direct light, sharp shadows, mirrors, refraction
  kPath,     ///< all of it, by random paths
};

}  // namespace lippmann
