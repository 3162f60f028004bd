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

/// The crosstalk through which an eye sees the pictures, in the same unit, at most kMaxBlurPx: as requested, or the display's;
/// 0 where neither says it, or where it is undone.
double crosstalk_at_eye(const RenderParams& params, const Optics& optics, const Display* display);

/// One sentence where errors are to be kept at the eye, and what it sees are single pixels; else empty.
std::string sharp_eye_sentence(const Reuse& reuse, const Optics& optics);

/// Throws a usage Error for crosstalk that nothing is made of: it is not undone, and no frame's error is told at the eye.
void check_crosstalk(const RenderParams& params, const Reuse& reuse);

}  // namespace lippmann
