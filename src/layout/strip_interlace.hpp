// The print below a lenticular sheet: every pixel shows the view, or the frame, whose part of its lens's strip it lies in.
// Private to this part.
#pragma once

#include "lippmann/layout/display_picture.hpp"

namespace lippmann {

/// `field`: views that a ViewFitter has fitted to the sheet, 2 or more in a row. Throws a usage Error for shares that are not
/// as many as the frames, and for a Gaussian filter.
Picture interlace_strips(const LightField& field, const Display& sheet, const DisplayPictureParams& params,
                         const ThreadPool& pool);

}  // namespace lippmann
