// Sentences for people that summarise a render: its kind of reuse, the pixels that were reused, and the estimated error.
#pragma once

#include <string>

#include "job/report.hpp"

namespace lippmann {

/// The kind of reuse (name_of()), followed by its effect.
std::string reuse_sentence(const RenderReport& report);

/// The PSNR of the frame with the largest error and its 90 % interval, e.g. "estimated error 42 dB (40 to 44)"; only the lower
/// bound if the held-out pixels show no error. Returns an empty string if no frame has an estimate.
std::string error_sentence(const std::vector<FrameReport>& frames);

}  // namespace lippmann
