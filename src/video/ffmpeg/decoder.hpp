// Decodes a video with FFmpeg, frame by frame. Private to the module.
#pragma once

#include <filesystem>
#include <memory>

#include "video/video_module.hpp"

namespace lippmann {

std::unique_ptr<VideoDecoder> make_decoder(const std::filesystem::path& path);

}  // namespace lippmann
