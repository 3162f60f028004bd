// FFmpeg helpers of this module: owning pointers, errors, logging. Include only from the module's .cpp files.
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

/// Takes ownership of an allocation of FFmpeg. Throws std::bad_alloc for null.
template <class T>
FfmpegPtr<T> own(T* p) {
  if (!p) throw std::bad_alloc();
  return FfmpegPtr<T>(p);
}

/// The message is "path: action: FFmpeg's message".
Error ffmpeg_error(const std::filesystem::path& path, const std::string& action, int code);

void silence_ffmpeg();

}  // namespace lippmann
