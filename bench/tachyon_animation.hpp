// Measures how long the program tachyon needs for frames of its own animations. The paper compares its savings with tachyon.
#pragma once

#include <optional>

#include "bench/scenes.hpp"

namespace lippmann::bench {

/// Returns the CPU seconds per frame along the animation's camera path, for frames of `pixels` pixels without antialiasing, on
/// one thread. The time to read the scene is excluded. Returns no value if the animation is not one of Tachyon's, or if the
/// program is not installed.
std::optional<double> tachyon_seconds_per_frame(const BenchAnimation& animation, double pixels);

}  // namespace lippmann::bench
