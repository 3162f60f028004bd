// Converts between pictures (8-bit RGB codes) and the frames of FFmpeg's encoders and decoders. Private to the module.
//
// RGB frames are copied code by code. YUV goes through libswscale with its exact, reproducible settings.
#pragma once

#include "lippmann/image/image.hpp"
#include "video/ffmpeg/ffmpeg.hpp"

namespace lippmann {

/// Pictures to frames of BGR0, or of a YUV format by BT.709, limited range.
class ToFrame {
 public:
  /// The frame's size; pictures may be smaller: their last column and row are repeated.
  ToFrame(int width, int height, AVPixelFormat format);

  /// The frame is overwritten by the next call, unless someone else holds a reference to it.
  AVFrame& convert(const Image8& picture);

 private:
  FfmpegPtr<AVFrame> rgb_, frame_;
  FfmpegPtr<SwsContext> scaler_;  // null for BGR0
};

/// Decoded frames, whose size and format may change from one to the next, to pictures.
class ToPicture {
 public:
  /// YUV by the frame's own matrix and range; unstated: BT.601, limited. Throws Error naming `path` if FFmpeg cannot convert
  /// it.
  Image8 convert(const std::filesystem::path& path, const AVFrame& frame);

 private:
  void prepare(const std::filesystem::path& path, const AVFrame& frame);

  FfmpegPtr<AVFrame> rgb_;
  FfmpegPtr<SwsContext> scaler_;
  AVPixelFormat format_ = AV_PIX_FMT_NONE;  // that scaler_ converts from
  AVColorSpace matrix_ = AVCOL_SPC_UNSPECIFIED;
  AVColorRange range_ = AVCOL_RANGE_UNSPECIFIED;
};

}  // namespace lippmann
