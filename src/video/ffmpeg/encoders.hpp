// Settings of FFmpeg's encoders, per codec. Private to the module.
#pragma once

#include "video/ffmpeg/ffmpeg.hpp"
#include "video/video_codec.hpp"

namespace lippmann {

/// RGB for FFV1; otherwise YUV with half the chroma resolution, which requires even sides.
AVPixelFormat pixel_format(VideoCodec codec);
int size_multiple(VideoCodec codec);

/// Sets quality, speed, and options that give the same output on every machine. Set the context's size, format and threads
/// before.
void configure(AVCodecContext& context, VideoCodec codec, int crf);

}  // namespace lippmann
