#pragma once

#include <optional>

#include "bench/scenes.hpp"

namespace lippmann::bench {

/// Returns the CPU seconds per frame along the animation's camera path, for frames of `pixels` pixels without antialiasing, on
/// one thread, or no value if the animation is not one of Tachyon's, or if the program is not installed. The time to read the
/// scene is excluded.
std::optional<double> tachyon_seconds_per_frame(const BenchAnimation& animation, double pixels);

}  // namespace lippmann::bench
