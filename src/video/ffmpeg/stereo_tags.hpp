// Tells players that frames hold the views of two eyes, and how. Private to the module.
//
//   .mkv, .webm  StereoMode; half packings also the shape of one view, which the container's display size is of
//   .mp4         st3d (Spherical Video V2), left eye first, side by side or one above the other; .mov has none
//   H.264        the frame packing message of the stream itself, left eye first
#pragma once

#include "lippmann/layout/stereo.hpp"
#include "video/ffmpeg/ffmpeg.hpp"

namespace lippmann {

/// Before the file's header is written.
void tag_stereo(AVFormatContext& muxer, AVStream& stream, const StereoLayout& layout);

/// For encoders that say it in their stream.
void tag_stereo(AVFrame& frame, const StereoLayout& layout);

}  // namespace lippmann
