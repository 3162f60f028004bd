// Which reuse served a render, what it did, and how large its error is: sentences for people.
#pragma once

#include <string>

#include "job/report.hpp"

namespace lippmann {

/// Begins with the name of the kind that served (name_of).
std::string reuse_sentence(const RenderReport& report);

/// "estimated error 42 dB (40 to 44)": the PSNR of the frame with the largest error and its 90 % interval. Empty without
/// estimates.
std::string error_sentence(const std::vector<FrameReport>& frames);

}  // namespace lippmann
