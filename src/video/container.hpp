// FFmpeg's names of containers and encoders. Private to src/video.
#pragma once

#include <filesystem>

#include "video/video_codec.hpp"

namespace lippmann {

const char* encoder_name(VideoCodec codec);

const char* muxer_name(const std::filesystem::path& path);

}  // namespace lippmann
