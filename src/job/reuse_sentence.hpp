// Sentences that summarise a render for the user.
#pragma once

#include <string>

#include "job/report.hpp"

namespace lippmann {

/// Names the kind of reuse and the share of reused pixels.
std::string reuse_sentence(const RenderReport& report);

/// Returns the PSNR and the 90 % interval of the frame with the largest error, such as "estimated error 42 dB (40 to
/// 44)", or only a lower bound if the held-out pixels, which are traced again, show no error. Returns an empty string
/// if no frame has an estimate.
std::string error_sentence(const std::vector<FrameReport>& frames);

}  // namespace lippmann
