// Encodes a video with FFmpeg and writes its file. Private to the module.
#pragma once

#include <memory>

#include "video/video_module.hpp"

namespace lippmann {

std::unique_ptr<VideoEncoder> make_encoder(const EncoderSettings& settings);

}  // namespace lippmann
