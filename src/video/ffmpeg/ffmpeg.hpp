// What the module's .cpp files share of FFmpeg's libraries: owners, errors, silence. Not to be included from anywhere else.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

#include <filesystem>
#include <memory>
#include <string>

#include "lippmann/core/error.hpp"

namespace lippmann {

struct FfmpegDeleter {
  void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
  void operator()(AVFrame* p) const { av_frame_free(&p); }
  void operator()(AVPacket* p) const { av_packet_free(&p); }
  void operator()(SwsContext* p) const { sws_freeContext(p); }
};
template <class T>
using FfmpegPtr = std::unique_ptr<T, FfmpegDeleter>;

/// Throws bad_alloc for null, as FFmpeg reports lack of memory.
template <class T>
FfmpegPtr<T> own(T* p) {
  if (!p) throw std::bad_alloc();
  return FfmpegPtr<T>(p);
}

/// "path: action: what FFmpeg says".
Error ffmpeg_error(const std::filesystem::path& path, const std::string& action, int code);

/// The libraries and encoders print to stderr by themselves; what matters reaches us as error codes.
void silence_ffmpeg();

}  // namespace lippmann
