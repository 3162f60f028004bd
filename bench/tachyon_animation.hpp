#pragma once

#include <optional>

#include "bench/scenes.hpp"

namespace lippmann::bench {

/// Returns the CPU seconds per frame of the program tachyon along the animation's camera path, on one thread, for frames of
/// `pixels` pixels without antialiasing. Excludes the time to read the scene. Returns no value if the animation is not one of
/// Tachyon's, or if the program is not installed.
std::optional<double> tachyon_seconds_per_frame(const BenchAnimation& animation, double pixels);

}  // namespace lippmann::bench
