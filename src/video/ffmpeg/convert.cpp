#include "video/ffmpeg/convert.hpp"

#include <algorithm>
#include <cstring>

namespace lippmann {
namespace {

constexpr int kExact = SWS_BICUBIC | SWS_ACCURATE_RND | SWS_BITEXACT | SWS_FULL_CHR_H_INT | SWS_FULL_CHR_H_INP;

/// neutral value of libswscale's brightness, contrast and saturation
constexpr int kUnchanged = 1 << 16;

FfmpegPtr<AVFrame> allocate_frame(AVPixelFormat format, int width, int height) {
  FfmpegPtr<AVFrame> frame = own(av_frame_alloc());
  frame->format = format, frame->width = width, frame->height = height;
  if (av_frame_get_buffer(frame.get(), 0) < 0) throw std::bad_alloc();
  return frame;
}

unsigned char* row(const AVFrame& frame, int y) { return frame.data[0] + std::ptrdiff_t{frame.linesize[0]} * y; }

const unsigned char* row(const Image8& picture, int y) { return picture.rgb.data() + std::size_t{3} * picture.width * y; }
unsigned char* row(Image8& picture, int y) { return picture.rgb.data() + std::size_t{3} * picture.width * y; }

void copy_padded(const Image8& picture, AVFrame& rgb) {
  for (int y = 0; y < rgb.height; ++y) {
    const unsigned char* from = row(picture, std::min(y, picture.height - 1));
    unsigned char* to = row(rgb, y);
    std::memcpy(to, from, std::size_t{3} * picture.width);
    for (int x = picture.width; x < rgb.width; ++x) std::memcpy(to + 3 * x, from + 3 * (picture.width - 1), 3);
  }
}

void copy_to_bgr0(const Image8& picture, AVFrame& frame) {
  for (int y = 0; y < frame.height; ++y) {
    const unsigned char* from = row(picture, y);
    unsigned char* to = row(frame, y);
    for (int x = 0; x < frame.width; ++x, from += 3, to += 4) to[0] = from[2], to[1] = from[1], to[2] = from[0], to[3] = 0;
  }
}

Image8 copy_from_bgr0(const AVFrame& frame, Image8 picture) {
  for (int y = 0; y < frame.height; ++y) {
    const unsigned char* from = row(frame, y);
    unsigned char* to = row(picture, y);
    for (int x = 0; x < frame.width; ++x, from += 4, to += 3) to[0] = from[2], to[1] = from[1], to[2] = from[0];
  }
  return picture;
}

int matrix_of(const AVFrame& frame) {
  switch (frame.colorspace) {
    case AVCOL_SPC_BT709:
      return SWS_CS_ITU709;
    case AVCOL_SPC_BT2020_NCL:
    case AVCOL_SPC_BT2020_CL:
      return SWS_CS_BT2020;
    case AVCOL_SPC_FCC:
      return SWS_CS_FCC;
    case AVCOL_SPC_SMPTE240M:
      return SWS_CS_SMPTE240M;
    default:
      return SWS_CS_DEFAULT;
  }
}

}  // namespace

ToFrame::ToFrame(int width, int height, AVPixelFormat format) : frame_(allocate_frame(format, width, height)) {
  if (format == AV_PIX_FMT_BGR0) return;
  rgb_ = allocate_frame(AV_PIX_FMT_RGB24, width, height);
  scaler_ = own(sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, format, kExact, nullptr, nullptr, nullptr));
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(scaler_.get(), bt709, 1, bt709, 0, 0, kUnchanged, kUnchanged);
}

AVFrame& ToFrame::convert(const Image8& picture) {
  if (av_frame_make_writable(frame_.get()) < 0) throw std::bad_alloc();
  if (!scaler_) {
    copy_to_bgr0(picture, *frame_);
    return *frame_;
  }
  copy_padded(picture, *rgb_);
  sws_scale(scaler_.get(), rgb_->data, rgb_->linesize, 0, rgb_->height, frame_->data, frame_->linesize);
  return *frame_;
}

void ToPicture::prepare(const std::filesystem::path& path, const AVFrame& frame) {
  const auto format = static_cast<AVPixelFormat>(frame.format);
  if (scaler_ && format == format_ && matrix_ == frame.colorspace && range_ == frame.color_range &&
      frame.width == rgb_->width && frame.height == rgb_->height)
    return;
  scaler_.reset(sws_getContext(frame.width, frame.height, format, frame.width, frame.height, AV_PIX_FMT_RGB24, kExact, nullptr,
                               nullptr, nullptr));
  if (!scaler_) throw Error(path.string(), "has pixels of a kind that FFmpeg cannot convert to RGB");
  const int* matrix = sws_getCoefficients(matrix_of(frame));
  const bool full_range = frame.color_range == AVCOL_RANGE_JPEG;
  sws_setColorspaceDetails(scaler_.get(), matrix, full_range ? 1 : 0, matrix, 1, 0, kUnchanged, kUnchanged);
  matrix_ = frame.colorspace, range_ = frame.color_range;
  rgb_ = allocate_frame(AV_PIX_FMT_RGB24, frame.width, frame.height);
  format_ = format;
}

Image8 ToPicture::convert(const std::filesystem::path& path, const AVFrame& frame) {
  Image8 picture{frame.width, frame.height, std::vector<unsigned char>(std::size_t{3} * frame.width * frame.height)};
  if (frame.format == AV_PIX_FMT_BGR0) return copy_from_bgr0(frame, std::move(picture));
  prepare(path, frame);
  if (sws_scale(scaler_.get(), frame.data, frame.linesize, 0, frame.height, rgb_->data, rgb_->linesize) != frame.height)
    throw Error(path.string(), "a frame cannot be converted to RGB");
  for (int y = 0; y < frame.height; ++y) std::memcpy(row(picture, y), row(*rgb_, y), std::size_t{3} * frame.width);
  return picture;
}

}  // namespace lippmann
