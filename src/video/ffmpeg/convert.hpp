// Converts between images (8-bit RGB codes) and FFmpeg frames. Private to the module. The settings of libswscale give the same
// result on every machine.
#pragma once

#include "lippmann/image/image.hpp"
#include "video/ffmpeg/ffmpeg.hpp"

namespace lippmann {

class ToFrame {
 public:
  /// Smaller images are padded by repeating their last column and row.
  ToFrame(int width, int height, AVPixelFormat format);

  /// The next call overwrites the returned frame, unless another reference to it exists.
  AVFrame& convert(const Image8& picture);

 private:
  FfmpegPtr<AVFrame> rgb_, frame_;
  FfmpegPtr<SwsContext> scaler_;  // null for BGR0, which needs no conversion
};

class ToPicture {
 public:
  /// Uses the YUV matrix and range that the frame states, or BT.601 limited range. Throws Error naming `path` if FFmpeg cannot
  /// convert the frame.
  Image8 convert(const std::filesystem::path& path, const AVFrame& frame);

 private:
  void prepare(const std::filesystem::path& path, const AVFrame& frame);

  FfmpegPtr<AVFrame> rgb_;
  FfmpegPtr<SwsContext> scaler_;
  AVPixelFormat format_ = AV_PIX_FMT_NONE;
  AVColorSpace matrix_ = AVCOL_SPC_UNSPECIFIED;
  AVColorRange range_ = AVCOL_RANGE_UNSPECIFIED;
};

}  // namespace lippmann
