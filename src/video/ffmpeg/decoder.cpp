#include "video/ffmpeg/decoder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "lippmann/core/math.hpp"
#include "video/ffmpeg/convert.hpp"
#include "video/ffmpeg/ffmpeg.hpp"

extern "C" {
#include <libavutil/imgutils.h>
#include <libavutil/pixdesc.h>
}

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct DemuxerDeleter {
  void operator()(AVFormatContext* p) const { avformat_close_input(&p); }
};

class FfmpegDecoder : public VideoDecoder {
 public:
  explicit FfmpegDecoder(const fs::path& name) : path_(name) {
    silence_ffmpeg();
    AVFormatContext* opened = avformat_alloc_context();
    if (!opened) throw std::bad_alloc();
    opened->error_recognition = AV_EF_CRCCHECK | AV_EF_EXPLODE;
    check(avformat_open_input(&opened, ("file:" + path_.string()).c_str(), nullptr, nullptr), "cannot be read as a video");
    demuxer_.reset(opened);
    check(avformat_find_stream_info(demuxer_.get(), nullptr), "cannot be read as a video");
    open_decoder();
  }

  std::optional<Image8> next() override {
    if (decode()) {
      check_frame();
      ++frames_;
      return converter_.convert(path_, *frame_);
    }
    check_complete();
    if (frames_ == 0) throw Error(path_.string(), "has no frames");
    return std::nullopt;
  }

 private:
  static constexpr int kMaxSide = 1 << 16;
  static constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;

  void check(int code, const char* action) const {
    if (code < 0) throw ffmpeg_error(path_, action, code);
  }

  /// libswscale asserts or reads beyond the frame if size or format, which come from the file, are invalid.
  void check_frame() {
    const Vec2i size(frame_->width, frame_->height);
    const auto wrong = [&](const std::string& problem) {
      return Error(path_.string(), fmt::format("frame {} {}", frames_, problem));
    };
    if (size.x < 1 || size.y < 1 || size.x > kMaxSide || size.y > kMaxSide || std::int64_t{size.x} * size.y > kMaxPixels)
      throw wrong(fmt::format("says that it has {}x{} pixels", size.x, size.y));
    if (frames_ == 0) size_ = size;
    if (size != size_)
      throw wrong(fmt::format("has {}x{} pixels, and the frames before it have {}x{}", size.x, size.y, size_.x, size_.y));
    const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame_->format));
    if (!format || (format->flags & AV_PIX_FMT_FLAG_HWACCEL) ||
        sws_isSupportedInput(static_cast<AVPixelFormat>(frame_->format)) <= 0)
      throw wrong("has pixels of a kind that FFmpeg cannot convert to RGB");
    for (int plane = 0; plane < av_pix_fmt_count_planes(static_cast<AVPixelFormat>(frame_->format)); ++plane) {
      const int row_bytes = av_image_get_linesize(static_cast<AVPixelFormat>(frame_->format), size.x, plane);
      if (!frame_->data[plane] || row_bytes < 0 || std::abs(frame_->linesize[plane]) < row_bytes)
        throw wrong("has rows shorter than its width");
    }
    if ((format->flags & AV_PIX_FMT_FLAG_PAL) && !frame_->data[1]) throw wrong("has no palette");
  }

  void open_decoder() {
    const AVCodec* decoder = nullptr;
    const int index = av_find_best_stream(demuxer_.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &decoder, 0);
    check(index, "has no video that can be decoded");
    stream_ = demuxer_->streams[index];
    codec_ = own(avcodec_alloc_context3(decoder));
    check(avcodec_parameters_to_context(codec_.get(), stream_->codecpar), "cannot be decoded");
    if (codec_->width > kMaxSide || codec_->height > kMaxSide || std::int64_t{codec_->width} * codec_->height > kMaxPixels)
      throw Error(path_.string(),
                  fmt::format("has frames of {} x {} pixels, empty or too large", codec_->width, codec_->height),
                  "sides up to 65536 pixels, up to 2^28 pixels");
    codec_->max_pixels = kMaxPixels;
    codec_->err_recognition = AV_EF_CRCCHECK | AV_EF_EXPLODE;
    codec_->thread_count = 1;
    check(avcodec_open2(codec_.get(), decoder, nullptr), "cannot be decoded");
  }

  void feed_decoder() {
    for (;;) {
      const int code = av_read_frame(demuxer_.get(), packet_.get());
      if (code == AVERROR_EOF) {
        ended_ = true;
        check(avcodec_send_packet(codec_.get(), nullptr), "cannot be decoded");
        return;
      }
      check(code, "is damaged or truncated");
      const bool ours = packet_->stream_index == stream_->index, damaged = packet_->flags & AV_PKT_FLAG_CORRUPT;
      if (ours && damaged) throw Error(path_.string(), fmt::format("is damaged or truncated after frame {}", frames_));
      if (ours) ++packets_, end_time_ = std::max(end_time_, packet_->pts + packet_->duration);
      const int sent = ours ? avcodec_send_packet(codec_.get(), packet_.get()) : 0;
      av_packet_unref(packet_.get());
      check(sent, "cannot be decoded");
      if (ours) return;
    }
  }

  bool decode() {
    for (;;) {
      const int code = avcodec_receive_frame(codec_.get(), frame_.get());
      if (code == AVERROR_EOF) return false;
      if (code == 0) return true;
      if (code != AVERROR(EAGAIN) || ended_) check(code, "is damaged or truncated");
      feed_decoder();
    }
  }

  /// Throws Error if the file is truncated, which demuxers treat as the end of the video. Compares the number of packets with
  /// the index (MP4), or the end of the last packet with the duration (Matroska files without other streams).
  void check_complete() const {
    const int indexed = avformat_index_get_entries_count(stream_);
    if (packets_ < indexed) throw Error(path_.string(), fmt::format("is truncated: {} of {} frames", packets_, indexed));
    if (demuxer_->nb_streams != 1 || demuxer_->duration <= 0 || packets_ == 0) return;
    const std::int64_t start = demuxer_->start_time == AV_NOPTS_VALUE ? 0 : demuxer_->start_time;
    const double promised = static_cast<double>(start + demuxer_->duration) / AV_TIME_BASE;
    const double read = static_cast<double>(end_time_) * av_q2d(stream_->time_base),
                 frame_time = read / static_cast<double>(packets_);
    if (promised - read > 0.5 * frame_time)
      throw Error(path_.string(), fmt::format("is truncated: {:.3f} of {:.3f} seconds", read, promised));
  }

  fs::path path_;
  std::unique_ptr<AVFormatContext, DemuxerDeleter> demuxer_;
  FfmpegPtr<AVCodecContext> codec_;
  ToPicture converter_;
  FfmpegPtr<AVFrame> frame_ = own(av_frame_alloc());
  FfmpegPtr<AVPacket> packet_ = own(av_packet_alloc());
  const AVStream* stream_ = nullptr;
  Vec2i size_{0, 0};
  std::int64_t frames_ = 0, packets_ = 0,
               end_time_ = 0;  // decoded frames, read packets, and end of the last packet in units of the stream's time base
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<VideoDecoder> make_decoder(const fs::path& path) { return std::make_unique<FfmpegDecoder>(path); }

}  // namespace lippmann
