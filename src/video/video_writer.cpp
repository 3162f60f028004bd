#include "video/video_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>

#include "core/atomic_file.hpp"
#include "video/convert.hpp"
#include "video/encoders.hpp"
#include "video/ffmpeg.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

int round_up(int value, int multiple) { return (value + multiple - 1) / multiple * multiple; }

/// Throws Error for options that make no sense for that codec.
int checked_crf(const fs::path& path, VideoCodec codec, std::optional<int> crf) {
  const std::optional<CrfRange> range = crf_range(codec);
  if (!range && crf)
    throw Error(path.string(), fmt::format("crf {} for {}, which loses nothing", *crf, name_of(codec)), "none");
  if (!range) return 0;
  const int value = crf.value_or(range->standard);
  if (value < 0 || value > range->highest)
    throw Error(path.string(), fmt::format("crf {} for {}", value, name_of(codec)), fmt::format("0 to {}", range->highest));
  return value;
}

/// Closes its file before it goes.
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

}  // namespace

struct VideoWriter::Impl {
  fs::path path;
  VideoOptions options;
  AtomicFile file;
  Muxer muxer;
  FfmpegPtr<AVCodecContext> codec;
  AVStream* stream = nullptr;
  std::optional<ToFrame> converter;
  FfmpegPtr<AVPacket> packet = own(av_packet_alloc());
  int width = 0, height = 0;
  std::int64_t frames = 0;

  Impl(const fs::path& name, const VideoOptions& wanted) : path(name), options(wanted), file(name) {
    silence_ffmpeg();
    if (options.rate.numerator <= 0 || options.rate.denominator <= 0)
      throw Error(path.string(), fmt::format("{}/{} frames per second", options.rate.numerator, options.rate.denominator),
                  "a rate above 0");
    checked_crf(path, choose_codec(path, options.codec, 0, 0), options.crf);
  }

  void check(int code, const char* action) const {
    if (code < 0) throw ffmpeg_error(path, action, code);
  }

  void open(const Image8& first) {
    width = first.width, height = first.height;
    const VideoCodec chosen = choose_codec(path, options.codec, width, height);
    if (std::min(width, height) < 2 && chosen == VideoCodec::kFfv1)  // FFmpeg 5.1's FFV1 brings back black
      throw Error(path.string(), fmt::format("frames of {} x {} pixels", width, height), "sides of at least 2 pixels");
    const int coded_width = round_up(width, size_multiple(chosen)), coded_height = round_up(height, size_multiple(chosen));
    converter.emplace(coded_width, coded_height, pixel_format(chosen));
    const std::string temporary = file.temporary_path().string();
    check(avformat_alloc_output_context2(&muxer.context, nullptr, muxer_name(path), temporary.c_str()), "cannot be set up");
    muxer.context->flags |= AVFMT_FLAG_BITEXACT;
    open_encoder(chosen, coded_width, coded_height);
    stream = avformat_new_stream(muxer.context, nullptr);
    if (!stream) throw std::bad_alloc();
    stream->time_base = codec->time_base;
    stream->avg_frame_rate = codec->framerate;
    check(avcodec_parameters_from_context(stream->codecpar, codec.get()), "cannot be set up");
    // The tag that QuickTime and Apple's players want; FFmpeg's own choice is hev1.
    if (chosen == VideoCodec::kHevc && is_mpeg4()) stream->codecpar->codec_tag = MKTAG('h', 'v', 'c', '1');
    check(avio_open(&muxer.context->pb, temporary.c_str(), AVIO_FLAG_WRITE), "cannot be created");
    AVDictionary* muxer_options = nullptr;
    if (is_mpeg4()) av_dict_set(&muxer_options, "movflags", "+faststart", 0);
    const int code = avformat_write_header(muxer.context, &muxer_options);
    av_dict_free(&muxer_options);
    check(code, "cannot be written");
  }

  void open_encoder(VideoCodec chosen, int coded_width, int coded_height) {
    const AVCodec* encoder = find_encoder(chosen);
    codec = own(avcodec_alloc_context3(encoder));
    codec->width = coded_width, codec->height = coded_height;
    codec->pix_fmt = pixel_format(chosen);
    codec->time_base = {options.rate.denominator, options.rate.numerator};
    codec->framerate = {options.rate.numerator, options.rate.denominator};
    codec->thread_count = std::max(1, options.threads);
    codec->flags |= AV_CODEC_FLAG_BITEXACT;
    if (muxer.context->oformat->flags & AVFMT_GLOBALHEADER) codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    configure(*codec, chosen, checked_crf(path, chosen, options.crf));
    check(avcodec_open2(codec.get(), encoder, nullptr),
          fmt::format("{} x {} pixels cannot be encoded as {}", coded_width, coded_height, name_of(chosen)).c_str());
  }

  bool is_mpeg4() const { return path.extension() == ".mp4" || path.extension() == ".mov"; }

  /// Gives one frame (null: the end) to the encoder and writes what comes out.
  void encode(const AVFrame* frame) {
    check(avcodec_send_frame(codec.get(), frame), "cannot be encoded");
    for (;;) {
      const int code = avcodec_receive_packet(codec.get(), packet.get());
      if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
      check(code, "cannot be encoded");
      packet->stream_index = stream->index;
      packet->duration = 1;
      av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
      check(av_interleaved_write_frame(muxer.context, packet.get()), "cannot be written");
    }
  }

  void add_frame(const Image8& frame) {
    assert(frame.rgb.size() == std::size_t{3} * frame.width * frame.height);
    if (frames == 0) open(frame);
    if (frame.width != width || frame.height != height)
      throw Error(path.string(), fmt::format("frame {} has {} x {} pixels, the first one {} x {}", frames, frame.width,
                                             frame.height, width, height));
    AVFrame& converted = converter->convert(frame);
    converted.pts = frames++;
    encode(&converted);
  }

  void finish() {
    if (frames == 0) throw Error(path.string(), "a video without frames");
    encode(nullptr);
    check(av_write_trailer(muxer.context), "cannot be written");
    check(muxer.context->pb->error, "cannot be written");
    check(avio_closep(&muxer.context->pb), "cannot be written");
    file.commit();
  }
};

VideoWriter::VideoWriter(const fs::path& path, const VideoOptions& options) : impl_(std::make_unique<Impl>(path, options)) {}
VideoWriter::~VideoWriter() = default;
void VideoWriter::add_frame(const Image8& frame) { impl_->add_frame(frame); }
void VideoWriter::finish() { impl_->finish(); }

FrameRate frame_rate(double frames_per_second) {
  const double whole = std::round(frames_per_second);
  if (whole >= 1.0 && whole <= 1e6) {
    if (std::abs(frames_per_second - whole) < 1e-6) return {static_cast<int>(whole), 1};
    if (std::abs(frames_per_second - whole / 1.001) < 1e-5 * whole) return {static_cast<int>(whole) * 1000, 1001};
  }
  const AVRational nearest = av_d2q(frames_per_second, 1000000);
  return {nearest.num, nearest.den};
}

void check_video_path(const fs::path& path, const VideoOptions& options, int width, int height) {
  checked_crf(path, choose_codec(path, options.codec, width, height), options.crf);
  const AtomicFile writable(path);
}

}  // namespace lippmann
