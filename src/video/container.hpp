// FFmpeg's names for what choose_codec() has accepted. Private to this part.
#pragma once

#include <filesystem>

#include "video/video_codec.hpp"

namespace lippmann {

const char* encoder_name(VideoCodec codec);

/// Throws Error naming the file for an unknown ending.
const char* muxer_name(const std::filesystem::path& path);

}  // namespace lippmann
