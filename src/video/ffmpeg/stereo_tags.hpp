// Writes metadata about the stereo layout of the frames. Private to the module.
//
//   .mkv, .webm  StereoMode. For half packings, the display size has the aspect ratio of one view.
//   .mp4         st3d (Spherical Video V2), only for layouts with the left eye first, side by side or one above the other
//   .mov         no tag
//   H.264        a frame packing message in the stream itself, only for layouts with the left eye first
#pragma once

#include "lippmann/layout/stereo.hpp"
#include "video/ffmpeg/ffmpeg.hpp"

namespace lippmann {

/// Call before writing the file header.
void tag_stereo(AVFormatContext& muxer, AVStream& stream, const StereoLayout& layout);

/// Tags a frame, so that H.264 encoders write the layout into the stream.
void tag_stereo(AVFrame& frame, const StereoLayout& layout);

}  // namespace lippmann
