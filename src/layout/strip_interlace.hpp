// Makes the print below a lenticular sheet. The strip below each lens is divided into equal parts, one per view, or
// into parts of given widths, one per flip frame. Private to src/layout.
#pragma once

#include "lippmann/layout/display_picture.hpp"

namespace lippmann {

/// `field`: 2 or more views in a row, fitted to the sheet by a ViewFitter. Throws a usage Error if the filter is
/// Gaussian, or if FlipParams::shares is given and does not have one element per frame.
Picture interlace_strips(const LightField& field, const Display& sheet, const DisplayPictureParams& params,
                         const ThreadPool& pool);

}  // namespace lippmann
