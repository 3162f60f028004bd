#include "video/video_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>

#include "core/atomic_file.hpp"
#include "lippmann/core/error.hpp"
#include "video/container.hpp"
#include "video/video_module.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Returns the last convergent of the value's continued fraction with numerator and denominator up to a million.
FrameRate nearest_fraction(double value) {
  constexpr double kLargest = 1e6;
  double before[2] = {0.0, 1.0}, last[2] = {1.0, 0.0};
  double rest = value;
  for (;;) {
    const double whole = std::floor(rest);
    const double next[2] = {whole * last[0] + before[0], whole * last[1] + before[1]};
    if (!(next[0] <= kLargest && next[1] <= kLargest)) break;
    std::copy_n(last, 2, before), std::copy_n(next, 2, last);
    if (rest - whole < 1e-9) break;
    rest = 1.0 / (rest - whole);
  }
  return {static_cast<int>(last[0]), static_cast<int>(last[1])};
}

/// Returns the codec's default if `crf` is empty, and 0 for lossless codecs. Throws Error if the codec does not support `crf`.
int checked_crf(const fs::path& path, VideoCodec codec, std::optional<int> crf) {
  const std::optional<CrfRange> range = crf_range(codec);
  if (!range && crf)
    throw Error(path.string(), fmt::format("crf {} has no effect: {} is lossless", *crf, name_of(codec)), "another codec");
  if (!range) return 0;
  const int value = crf.value_or(range->standard);
  if (value < 0 || value > range->highest)
    throw Error(path.string(), fmt::format("crf {} for {}", value, name_of(codec)), fmt::format("0 to {}", range->highest));
  return value;
}

}  // namespace

struct VideoWriter::Impl {
  fs::path path;
  VideoOptions options;
  AtomicFile file;
  std::unique_ptr<VideoEncoder> encoder;
  int width = 0, height = 0;
  std::int64_t frames = 0;

  Impl(const fs::path& name, const VideoOptions& wanted) : path(name), options(wanted), file(name) {
    if (options.rate.numerator <= 0 || options.rate.denominator <= 0)
      throw Error(path.string(),
                  fmt::format("cannot play {}/{} frames per second", options.rate.numerator, options.rate.denominator),
                  "a rate above 0");
    checked_crf(path, choose_codec(path, options.codec, 0, 0), options.crf);
  }

  void open(const Image8& first) {
    width = first.width, height = first.height;
    const VideoCodec chosen = choose_codec(path, options.codec, width, height);
    if (std::min(width, height) < 2 && chosen == VideoCodec::kFfv1)  // FFmpeg 5.1 decodes such FFV1 frames as black
      throw Error(path.string(), fmt::format("cannot hold frames of {} x {} pixels", width, height),
                  "sides of at least 2 pixels");
    encoder = video_module().encoder({.path = path,
                                      .temporary = file.temporary_path().string(),
                                      .codec = chosen,
                                      .muxer = muxer_name(path),
                                      .encoder = encoder_name(chosen),
                                      .width = width,
                                      .height = height,
                                      .crf = checked_crf(path, chosen, options.crf),
                                      .numerator = options.rate.numerator,
                                      .denominator = options.rate.denominator,
                                      .threads = options.threads,
                                      .stereo = options.stereo});
  }

  void add_frame(const Image8& frame) {
    assert(frame.rgb.size() == std::size_t{3} * frame.width * frame.height);
    if (frames == 0) open(frame);
    if (frame.width != width || frame.height != height)
      throw Error(path.string(), fmt::format("frame {} has {} x {} pixels, the first one {} x {}", frames, frame.width,
                                             frame.height, width, height));
    encoder->add_frame(frame);
    ++frames;
  }

  void finish() {
    if (frames == 0) throw Error(path.string(), "a video without frames");
    encoder->finish();
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
  return nearest_fraction(frames_per_second);
}

void warn_of_mixed_rows(const fs::path& path, const VideoOptions& options, Vec2i size, const Context& context) {
  if (!options.stereo || options.stereo->packing != StereoPacking::kRows) return;
  const VideoCodec codec = choose_codec(path, options.codec, size.x, size.y);
  if (codec == VideoCodec::kFfv1) return;
  context.warning(
      fmt::format("{}: {} shares colour between neighbouring rows, which are of different eyes. An .mkv with FFV1 keeps them "
                  "apart.",
                  path.string(), name_of(codec)));
}

void check_video_path(const fs::path& path, const VideoOptions& options, int width, int height) {
  checked_crf(path, choose_codec(path, options.codec, width, height), options.crf);
  const AtomicFile writable(path);
}

}  // namespace lippmann
