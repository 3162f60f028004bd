// The plain picture beside a light field: the same frames seen by one eye in the middle, for screens without lenses.
#pragma once

#include "job/params.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the parameters that render the plain picture into the folder kSingleFolder beside the light field's pictures, with
/// videos named NAME_single.mp4 etc. optics: the optics of `params`. The picture is as wide as the panel, or as one view of a
/// quilt; for a display, it has the panel's size.
RenderParams single_clip(const RenderParams& params, const Optics& optics);

}  // namespace lippmann
