// What a report tells about an animation whose path-traced frames may share light: how many do, how good all are as measured,
// and which of them may miss the PSNR that was asked for. Sentences for people; report.json has the figures.
#pragma once

#include <string>
#include <vector>

#include "job/report.hpp"

namespace lippmann {

/// How many frames share light; the PSNR of the mean squared error of those that were measured, and the worst frames with their
/// numbers, of pixels, at the eye where that differs, and of means over 64 pixels.
std::string shared_light_sentence(const std::vector<FrameReport>& frames);

/// The frames whose PSNR at 95 % confidence, of single pixels or at the eye, is below `min_psnr_db`, and how many of them are
/// below it as measured. Empty where there are none.
std::string below_floor_sentence(const std::vector<FrameReport>& frames, double min_psnr_db,
                                 QualityAt where = QualityAt::kPixel);

/// The frames whose errors are not measured. Empty where there are none.
std::string unmeasured_sentence(const std::vector<FrameReport>& frames, double min_psnr_db);

}  // namespace lippmann
