// Measures the time of the program tachyon for frames of its own animations, because tachyon was the baseline of the paper.
#pragma once

#include <optional>

#include "bench/scenes.hpp"

namespace lippmann::bench {

/// Returns the CPU seconds per frame along the animation's camera path, for frames of `pixels` pixels without antialiasing, on
/// one thread. The time to read the scene does not count. Returns no value if the animation is not Tachyon's or the program is
/// not installed.
std::optional<double> tachyon_seconds_per_frame(const BenchAnimation& animation, double pixels);

}  // namespace lippmann::bench
