#pragma once

#include <optional>

#include "job/params.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Returns the crosstalk that `--precompensate` corrects: the standard deviation of the Gaussian blur
/// (optics/crosstalk.hpp), in pixels, or in views for a quilt. It is the requested value, or that of the display.
/// Throws a usage Error if the value is unknown or too large, or if the optics have no neighbouring pixels.
std::optional<double> crosstalk_to_undo(const RenderParams& params, const Optics& optics, const Display* display);

}  // namespace lippmann
