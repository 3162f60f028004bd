// What the program tachyon takes for frames of an animation of its own: the paper's comparison, whose baseline it was.
#pragma once

#include <optional>

#include "bench/scenes.hpp"

namespace lippmann::bench {

/// CPU seconds per frame of so many pixels, without antialiasing, one thread, from the animation's own camera path; reading the
/// scene does not count. None where the animation is not one of Tachyon's, or the program is not there.
std::optional<double> tachyon_seconds_per_frame(const BenchAnimation& animation, double pixels);

}  // namespace lippmann::bench
