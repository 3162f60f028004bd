// Sentences that summarise a render for the user: the kind of reuse, the share of reused pixels, and the estimated error.
#pragma once

#include <string>

#include "job/report.hpp"

namespace lippmann {

/// Returns text that names the kind of reuse and states its effect.
std::string reuse_sentence(const RenderReport& report);

/// Returns the PSNR and the 90 % interval of the frame with the largest error, such as "estimated error 42 dB (40 to 44)". The
/// error is estimated from held-out pixels, which are traced again for this purpose. If they show no error, returns only the
/// lower bound. Returns an empty string if no frame has an estimate.
std::string error_sentence(const std::vector<FrameReport>& frames);

}  // namespace lippmann
