// `--precompensate`: a render's films made such that the display's crosstalk turns them into the wanted pictures.
#pragma once

#include <optional>

#include "job/params.hpp"
#include "layout/precompensate.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/image/encoding.hpp"

namespace lippmann {

/// The crosstalk to be undone, a sigma in the optics' pixels or views: as said, or the display's (whose pixels, of a quilt for
/// it, are so many views); none: nothing asked for. Throws a usage Error where nobody says it, it is too large, or the optics
/// have no neighbours.
std::optional<double> crosstalk_to_undo(const RenderParams& params, const Optics& optics, const Display* display);

/// precompensate() of a film of any encoding: values between 0 and 1 as they will be shown.
Precompensation undo_crosstalk(const Optics& optics, double sigma_px, Encoding encoding, Image& film);

}  // namespace lippmann
