#include "video/ffmpeg/encoder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "video/ffmpeg/convert.hpp"
#include "video/ffmpeg/encoders.hpp"
#include "video/ffmpeg/ffmpeg.hpp"
#include "video/ffmpeg/stereo_tags.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

int round_up(int value, int multiple) { return (value + multiple - 1) / multiple * multiple; }

/// Closes the file before it frees FFmpeg's muxer.
struct Muxer {
  AVFormatContext* context = nullptr;

  Muxer() = default;
  Muxer(const Muxer&) = delete;
  Muxer& operator=(const Muxer&) = delete;
  ~Muxer() {
    if (context) avio_closep(&context->pb);
    avformat_free_context(context);
  }
};

/// Checks a decoding time against the presentation time, both in frames. In very short videos, libx265 reads the decoding time
/// from uninitialised memory.
bool is_plausible(std::int64_t dts, std::int64_t pts) {
  constexpr std::int64_t kMostReordered = 64;
  return dts <= pts && pts <= dts + kMostReordered;
}

class FfmpegEncoder : public VideoEncoder {
 public:
  explicit FfmpegEncoder(const EncoderSettings& settings) : settings_(settings) {
    silence_ffmpeg();
    const int width = round_up(settings.width, size_multiple(settings.codec)),
              height = round_up(settings.height, size_multiple(settings.codec));
    converter_.emplace(width, height, pixel_format(settings.codec));
    check(avformat_alloc_output_context2(&muxer_.context, nullptr, settings.muxer, settings.temporary.c_str()),
          "cannot be set up");
    muxer_.context->flags |= AVFMT_FLAG_BITEXACT;
    open_encoder(width, height);
    open_file();
  }

  void add_frame(const Image8& frame) override {
    AVFrame& converted = converter_->convert(frame);
    converted.pts = frames_++;
    if (settings_.stereo) tag_stereo(converted, *settings_.stereo);
    encode(&converted);
  }

  void finish() override {
    encode(nullptr);
    check(av_write_trailer(muxer_.context), "cannot be written");
    check(muxer_.context->pb->error, "cannot be written");
    check(avio_closep(&muxer_.context->pb), "cannot be written");
  }

 private:
  void check(int code, const char* action) const {
    if (code < 0) throw ffmpeg_error(settings_.path, action, code);
  }

  bool is_mpeg4() const {
    const std::string_view muxer = settings_.muxer;
    return muxer == "mp4" || muxer == "mov";
  }

  void open_encoder(int width, int height) {
    const AVCodec* encoder = avcodec_find_encoder_by_name(settings_.encoder);
    codec_ = own(avcodec_alloc_context3(encoder));
    codec_->width = width, codec_->height = height;
    codec_->pix_fmt = pixel_format(settings_.codec);
    codec_->time_base = {settings_.denominator, settings_.numerator};
    codec_->framerate = {settings_.numerator, settings_.denominator};
    codec_->thread_count = std::max(1, settings_.threads);
    codec_->flags |= AV_CODEC_FLAG_BITEXACT;
    if (muxer_.context->oformat->flags & AVFMT_GLOBALHEADER) codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    configure(*codec_, settings_.codec, settings_.crf);
    check(avcodec_open2(codec_.get(), encoder, nullptr),
          fmt::format("{} x {} pixels cannot be encoded as {}", width, height, name_of(settings_.codec)).c_str());
  }

  void open_file() {
    stream_ = avformat_new_stream(muxer_.context, nullptr);
    if (!stream_) throw std::bad_alloc();
    stream_->time_base = codec_->time_base;
    stream_->avg_frame_rate = codec_->framerate;
    check(avcodec_parameters_from_context(stream_->codecpar, codec_.get()), "cannot be set up");
    // Apple's players require the tag hvc1; FFmpeg's default is hev1.
    if (settings_.codec == VideoCodec::kHevc && is_mpeg4()) stream_->codecpar->codec_tag = MKTAG('h', 'v', 'c', '1');
    if (settings_.stereo) tag_stereo(*muxer_.context, *stream_, *settings_.stereo);
    check(avio_open(&muxer_.context->pb, settings_.temporary.c_str(), AVIO_FLAG_WRITE), "cannot be created");
    AVDictionary* muxer_options = nullptr;
    if (is_mpeg4()) av_dict_set(&muxer_options, "movflags", "+faststart", 0);
    const int code = avformat_write_header(muxer_.context, &muxer_options);
    av_dict_free(&muxer_options);
    check(code, "cannot be written");
  }

  void encode(const AVFrame* frame) {
    check(avcodec_send_frame(codec_.get(), frame), "cannot be encoded");
    for (;;) {
      const int code = avcodec_receive_packet(codec_.get(), packet_.get());
      if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
      check(code, "cannot be encoded");
      packet_->stream_index = stream_->index;
      packet_->duration = 1;
      if (!is_plausible(packet_->dts, packet_->pts)) packet_->dts = AV_NOPTS_VALUE;  // the muxer derives dts from pts
      av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
      check(av_interleaved_write_frame(muxer_.context, packet_.get()), "cannot be written");
    }
  }

  EncoderSettings settings_;
  Muxer muxer_;
  FfmpegPtr<AVCodecContext> codec_;
  AVStream* stream_ = nullptr;
  std::optional<ToFrame> converter_;
  FfmpegPtr<AVPacket> packet_ = own(av_packet_alloc());
  std::int64_t frames_ = 0;
};

}  // namespace

std::unique_ptr<VideoEncoder> make_encoder(const EncoderSettings& settings) {
  return std::make_unique<FfmpegEncoder>(settings);
}

}  // namespace lippmann
