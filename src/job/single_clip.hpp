// Derives a second render from that of a light field: the same frames with a single view, for screens without lenses. The view
// is that of an eye in front of the middle of the display.
#pragma once

#include "job/params.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the parameters that render the scene with a single view into kSingleFolder, a folder in the folder of the
/// light field. Its videos are named NAME_single.mp4 etc. `optics` are those of `params`. The picture has the size of
/// the display's panel or, without a display, of the panel or of one view of a quilt.
RenderParams single_clip(const RenderParams& params, const Optics& optics);

}  // namespace lippmann
