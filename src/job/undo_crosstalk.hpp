// `--precompensate`: which crosstalk of the display its pictures are to undo.
#pragma once

#include <optional>

#include "job/params.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// The crosstalk to be undone, a sigma in the optics' pixels or views: as requested, or the display's (whose pixels, of a quilt
/// for it, are so many views); none: nothing asked for. Throws a usage Error where nobody says it, it is too large, or the
/// optics have no neighbours.
std::optional<double> crosstalk_to_undo(const RenderParams& params, const Optics& optics, const Display* display);

}  // namespace lippmann
