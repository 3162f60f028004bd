#include "video/video_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "video/convert.hpp"
#include "video/ffmpeg.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct DemuxerDeleter {
  void operator()(AVFormatContext* p) const { avformat_close_input(&p); }
};

}  // namespace

struct VideoReader::Impl {
  fs::path path;
  std::unique_ptr<AVFormatContext, DemuxerDeleter> demuxer;
  FfmpegPtr<AVCodecContext> codec;
  ToPicture converter;
  FfmpegPtr<AVFrame> frame = own(av_frame_alloc());
  FfmpegPtr<AVPacket> packet = own(av_packet_alloc());
  const AVStream* stream = nullptr;
  std::int64_t frames = 0, packets = 0, end_time = 0;  // of the packets read; time in the stream's units
  bool ended = false;                                  // of the packets; the decoder may still hold frames

  explicit Impl(const fs::path& name) : path(name) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) throw Error(path.string(), "there is no such file");
    if (!fs::is_regular_file(path, ignored)) throw Error(path.string(), "is not a file");
    silence_ffmpeg();
    AVFormatContext* opened = avformat_alloc_context();
    if (!opened) throw std::bad_alloc();
    opened->error_recognition = AV_EF_CRCCHECK | AV_EF_EXPLODE;
    check(avformat_open_input(&opened, ("file:" + path.string()).c_str(), nullptr, nullptr), "cannot be read as a video");
    demuxer.reset(opened);
    check(avformat_find_stream_info(demuxer.get(), nullptr), "cannot be read as a video");
    open_decoder();
  }

  void check(int code, const char* action) const {
    if (code < 0) throw ffmpeg_error(path, action, code);
  }

  void open_decoder() {
    const AVCodec* decoder = nullptr;
    const int index = av_find_best_stream(demuxer.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &decoder, 0);
    check(index, "has no video that can be decoded");
    stream = demuxer->streams[index];
    codec = own(avcodec_alloc_context3(decoder));
    check(avcodec_parameters_to_context(codec.get(), stream->codecpar), "cannot be decoded");
    constexpr int kMaxSide = 1 << 16;
    constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;
    if (codec->width > kMaxSide || codec->height > kMaxSide || std::int64_t{codec->width} * codec->height > kMaxPixels)
      throw Error(path.string(), fmt::format("frames of {} x {} pixels", codec->width, codec->height),
                  "sides up to 65536 pixels, up to 2^28 pixels");
    codec->max_pixels = kMaxPixels;
    codec->err_recognition = AV_EF_CRCCHECK | AV_EF_EXPLODE;
    codec->thread_count = 1;
    check(avcodec_open2(codec.get(), decoder, nullptr), "cannot be decoded");
  }

  /// Hands the decoder the stream's next packet, or the news that there are no more.
  void feed_decoder() {
    for (;;) {
      const int code = av_read_frame(demuxer.get(), packet.get());
      if (code == AVERROR_EOF) {
        ended = true;
        check(avcodec_send_packet(codec.get(), nullptr), "cannot be decoded");
        return;
      }
      check(code, "is damaged or truncated");
      const bool ours = packet->stream_index == stream->index, damaged = packet->flags & AV_PKT_FLAG_CORRUPT;
      if (ours && damaged) throw Error(path.string(), fmt::format("is damaged or truncated after frame {}", frames));
      if (ours) ++packets, end_time = std::max(end_time, packet->pts + packet->duration);
      const int sent = ours ? avcodec_send_packet(codec.get(), packet.get()) : 0;
      av_packet_unref(packet.get());
      check(sent, "cannot be decoded");
      if (ours) return;
    }
  }

  bool decode() {
    for (;;) {
      const int code = avcodec_receive_frame(codec.get(), frame.get());
      if (code == AVERROR_EOF) return false;
      if (code == 0) return true;
      if (code != AVERROR(EAGAIN) || ended) check(code, "is damaged or truncated");
      feed_decoder();
    }
  }

  /// Demuxers take the end of the file for the end of the video. What the headers promise tells whether it is: an index with
  /// more entries (MP4), or a duration beyond the last frame (Matroska; only told apart from other streams' where there are
  /// none).
  void check_complete() const {
    const int indexed = avformat_index_get_entries_count(stream);
    if (packets < indexed) throw Error(path.string(), fmt::format("is truncated: {} of {} frames", packets, indexed));
    if (demuxer->nb_streams != 1 || demuxer->duration <= 0 || packets == 0) return;
    const std::int64_t start = demuxer->start_time == AV_NOPTS_VALUE ? 0 : demuxer->start_time;
    const double promised = static_cast<double>(start + demuxer->duration) / AV_TIME_BASE;
    const double read = static_cast<double>(end_time) * av_q2d(stream->time_base),
                 frame_time = read / static_cast<double>(packets);
    if (promised - read > 0.5 * frame_time)
      throw Error(path.string(), fmt::format("is truncated: {:.3f} of {:.3f} seconds", read, promised));
  }

  std::optional<Image8> next() {
    if (decode()) {
      ++frames;
      return converter.convert(path, *frame);
    }
    check_complete();
    if (frames == 0) throw Error(path.string(), "has no frames");
    return std::nullopt;
  }
};

VideoReader::VideoReader(const fs::path& path) : impl_(std::make_unique<Impl>(path)) {}
VideoReader::~VideoReader() = default;
std::optional<Image8> VideoReader::next() { return impl_->next(); }

bool is_video_name(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::array known = {".mp4", ".mkv", ".mov", ".webm", ".avi", ".m4v"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

}  // namespace lippmann
