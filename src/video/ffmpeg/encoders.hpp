// What the encoders of FFmpeg are told, per codec. Private to the module.
#pragma once

#include "video/ffmpeg/ffmpeg.hpp"
#include "video/video_codec.hpp"

namespace lippmann {

/// FFV1 keeps RGB; the others take YUV at half the resolution of colour, whose sides must be even.
AVPixelFormat pixel_format(VideoCodec codec);
int size_multiple(VideoCodec codec);

/// Quality, speed, and whatever keeps an encoder's bytes the same on every machine. Size and format are set before, threads
/// too: bytes may depend on them.
void configure(AVCodecContext& context, VideoCodec codec, int crf);

}  // namespace lippmann
