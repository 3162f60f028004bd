// Makes the print below a lenticular sheet: every pixel shows the view or frame of its part of the lens's strip. Private to
// this part.
#pragma once

#include "lippmann/layout/display_picture.hpp"

namespace lippmann {

/// Returns the print. `field`: 2 or more views in a row, fitted to the sheet by a ViewFitter. Throws a usage Error for a
/// Gaussian filter, and if the number of shares differs from the number of frames.
Picture interlace_strips(const LightField& field, const Display& sheet, const DisplayPictureParams& params,
                         const ThreadPool& pool);

}  // namespace lippmann
