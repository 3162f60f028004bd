// The plain picture beside a light field: a render of the same frames as one eye in the middle sees them, for screens without
// lenses.
#pragma once

#include "job/params.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the parameters that render the ordinary picture of the scene, with a single view, into kSingleFolder, a folder in
/// the folder of the light field. The videos of this picture are named NAME_single.mp4 etc. `optics` are the optics of
/// `params`. With a display, the picture has the size of the display's panel. Without a display, it has the size of the panel,
/// or of one view of a quilt.
RenderParams single_clip(const RenderParams& params, const Optics& optics);

}  // namespace lippmann
