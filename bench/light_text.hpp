// The figures of one row of `lippmann bench light` for people, beside the bars that they have to clear.
#pragma once

#include <optional>
#include <string>

#include "bench/light_run.hpp"

namespace lippmann::bench {

/// What is asked of a scene.
struct LightBar {
  double saving = 0.0;                       ///< of CPU time, at least
  double gain_db = 0.0;                      ///< PSNR over the full render's, at least
  std::optional<double> equal_time_gain_db;  ///< PSNR over that of a full render of the same time, at least
};

inline constexpr double kMemoryBar = 300e6;  ///< bytes beyond a full render, of pictures of
inline constexpr int kMemoryBarPixels = 512 * 512;

/// Several lines, with a heading. `bar`: none is asked of scenes of the user's own.
std::string light_text(const LightCase& wanted, const LightSettings& settings, const LightRun& run,
                       const std::optional<LightBar>& bar);

}  // namespace lippmann::bench
