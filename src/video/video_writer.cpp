#include "video/video_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>

#include "core/atomic_file.hpp"
#include "video/convert.hpp"
#include "video/ffmpeg.hpp"

extern "C" {
#include <libavutil/opt.h>
}

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct OutputFormat {
  const char* muxer;
  const char* encoder;
  AVPixelFormat pixels;
  int size_multiple;  ///< of both sides
};

OutputFormat format_for(const fs::path& path) {
  if (path.extension() == ".mp4") return {"mp4", "libx264", AV_PIX_FMT_YUV420P, 2};
  if (path.extension() == ".mkv") return {"matroska", "ffv1", AV_PIX_FMT_BGR0, 1};
  throw Error(path.string(), "unknown kind of video file", ".mp4 (H.264), .mkv (FFV1, lossless)");
}

const AVCodec* find_encoder(const fs::path& path, const char* name) {
  if (const AVCodec* codec = avcodec_find_encoder_by_name(name)) return codec;
  throw Error(path.string(),
              fmt::format("this build of FFmpeg has no encoder {} (libx264 is only in builds under the GPL)", name));
}

int round_up(int value, int multiple) { return (value + multiple - 1) / multiple * multiple; }

void tag_colours(AVCodecContext& codec) {
  codec.color_primaries = AVCOL_PRI_BT709;
  codec.color_trc = AVCOL_TRC_BT709;
  if (codec.pix_fmt != AV_PIX_FMT_YUV420P) return;
  codec.colorspace = AVCOL_SPC_BT709;
  codec.color_range = AVCOL_RANGE_MPEG;
  codec.chroma_sample_location = AVCHROMA_LOC_LEFT;
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
  OutputFormat format;
  const AVCodec* encoder;
  AtomicFile file;
  Muxer muxer;
  FfmpegPtr<AVCodecContext> codec;
  AVStream* stream = nullptr;
  std::optional<ToFrame> converter;
  FfmpegPtr<AVPacket> packet = own(av_packet_alloc());
  int width = 0, height = 0;
  std::int64_t frames = 0;

  Impl(const fs::path& name, const VideoOptions& wanted)
      : path(name), options(wanted), format(format_for(name)), encoder(find_encoder(name, format.encoder)), file(name) {
    silence_ffmpeg();
    if (options.rate.numerator <= 0 || options.rate.denominator <= 0)
      throw Error(path.string(), fmt::format("{}/{} frames per second", options.rate.numerator, options.rate.denominator),
                  "a rate above 0");
    if (options.crf < 0 || options.crf > 51) throw Error(path.string(), fmt::format("crf {}", options.crf), "0 to 51");
  }

  void check(int code, const char* action) const {
    if (code < 0) throw ffmpeg_error(path, action, code);
  }

  void open(const Image8& first) {
    width = first.width, height = first.height;
    if (std::min(width, height) < 2 && format.pixels == AV_PIX_FMT_BGR0)  // FFmpeg 5.1's FFV1 brings back black
      throw Error(path.string(), fmt::format("frames of {} x {} pixels", width, height), "sides of at least 2 pixels");
    const int coded_width = round_up(width, format.size_multiple), coded_height = round_up(height, format.size_multiple);
    converter.emplace(coded_width, coded_height, format.pixels);
    const std::string temporary = file.temporary_path().string();
    check(avformat_alloc_output_context2(&muxer.context, nullptr, format.muxer, temporary.c_str()), "cannot be set up");
    muxer.context->flags |= AVFMT_FLAG_BITEXACT;
    open_encoder(coded_width, coded_height);
    stream = avformat_new_stream(muxer.context, nullptr);
    if (!stream) throw std::bad_alloc();
    stream->time_base = codec->time_base;
    stream->avg_frame_rate = codec->framerate;
    check(avcodec_parameters_from_context(stream->codecpar, codec.get()), "cannot be set up");
    check(avio_open(&muxer.context->pb, temporary.c_str(), AVIO_FLAG_WRITE), "cannot be created");
    AVDictionary* muxer_options = nullptr;
    if (path.extension() == ".mp4") av_dict_set(&muxer_options, "movflags", "+faststart", 0);
    const int code = avformat_write_header(muxer.context, &muxer_options);
    av_dict_free(&muxer_options);
    check(code, "cannot be written");
  }

  void open_encoder(int coded_width, int coded_height) {
    codec = own(avcodec_alloc_context3(encoder));
    codec->width = coded_width, codec->height = coded_height;
    codec->pix_fmt = format.pixels;
    codec->time_base = {options.rate.denominator, options.rate.numerator};
    codec->framerate = {options.rate.numerator, options.rate.denominator};
    codec->thread_count = std::max(1, options.threads);
    codec->flags |= AV_CODEC_FLAG_BITEXACT;
    if (muxer.context->oformat->flags & AVFMT_GLOBALHEADER) codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    tag_colours(*codec);
    if (format.pixels == AV_PIX_FMT_YUV420P) {
      av_opt_set_int(codec->priv_data, "crf", options.crf, 0);
      // x264's macroblock tree reads memory that it never wrote (seen with x264 164): two encodings in one process then differ.
      av_opt_set_int(codec->priv_data, "mbtree", 0, 0);
    } else {
      codec->level = 3;
      codec->gop_size = 1;                                               // every frame can be read alone
      codec->slices = std::min(coded_width, coded_height) < 16 ? 1 : 4;  // whatever the threads: they must not change the bytes
      av_opt_set_int(codec->priv_data, "slicecrc", 1, 0);
    }
    check(avcodec_open2(codec.get(), encoder, nullptr),
          fmt::format("{} x {} pixels cannot be encoded", coded_width, coded_height).c_str());
  }

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

void check_video_path(const fs::path& path) {
  find_encoder(path, format_for(path).encoder);
  const AtomicFile writable(path);
}

}  // namespace lippmann
