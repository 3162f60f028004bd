// Measures the program tachyon on frames of its own animations, as in the paper, whose baseline it was.
#pragma once

#include <optional>

#include "bench/scenes.hpp"

namespace lippmann::bench {

/// Returns the CPU seconds per frame of this many pixels, without antialiasing, on one thread, along the animation's camera
/// path, not counting the time to read the scene. Returns no value if the animation is not Tachyon's or the program is not
/// installed.
std::optional<double> tachyon_seconds_per_frame(const BenchAnimation& animation, double pixels);

}  // namespace lippmann::bench
