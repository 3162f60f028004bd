// Selects the crosstalk to correct: `--precompensate`.
#pragma once

#include <optional>

#include "job/params.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Returns the crosstalk to correct, as a sigma in the optics' pixels or views: the requested value, or the display's (in
/// views, for a quilt). Returns nullopt if no correction is requested. Throws a usage Error if the value is unknown or too
/// large, or if the optics have no neighbouring pixels.
std::optional<double> crosstalk_to_undo(const RenderParams& params, const Optics& optics, const Display* display);

}  // namespace lippmann
