// Settings of FFmpeg's encoders, per codec. Private to the module.
#pragma once

#include "video/ffmpeg/ffmpeg.hpp"
#include "video/video_codec.hpp"

namespace lippmann {

/// Returns the pixel format: RGB for FFV1; for other codecs, YUV with half the chroma resolution, which requires even sides.
AVPixelFormat pixel_format(VideoCodec codec);
int size_multiple(VideoCodec codec);

/// Sets the quality, the speed, and options that make the output the same on every machine. Set the size, format and threads of
/// the context before.
void configure(AVCodecContext& context, VideoCodec codec, int crf);

}  // namespace lippmann
