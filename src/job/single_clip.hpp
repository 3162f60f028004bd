// The plain picture beside a light field: the same frames as one eye in the middle sees them, for screens without lenses.
#pragma once

#include "job/params.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// What renders it, into the folder kSingleFolder beside the pictures, videos as NAME_single.mp4 and the like. `optics`: those
/// that the params made. As wide as the panel, or as one view of a quilt; on a display, as its panel.
RenderParams single_clip(const RenderParams& params, const Optics& optics);

}  // namespace lippmann
