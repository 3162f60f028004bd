// Settings of FFmpeg's encoders, per codec. Private to the module.
#pragma once

#include "video/ffmpeg/ffmpeg.hpp"
#include "video/video_codec.hpp"

namespace lippmann {

/// Returns the pixel format: RGB for FFV1, otherwise YUV with half the chroma resolution, which needs even sides.
AVPixelFormat pixel_format(VideoCodec codec);
int size_multiple(VideoCodec codec);

/// Sets quality, speed, and the options that make the output the same on every machine. Set the size, format and threads
/// before, because the options may depend on them.
void configure(AVCodecContext& context, VideoCodec codec, int crf);

}  // namespace lippmann
