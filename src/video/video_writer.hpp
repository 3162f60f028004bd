// Writes frames as a video file, for watching (H.264, HEVC, VP9, AV1) or to keep every code (FFV1).
//
//   .mp4, .mov  H.264, HEVC (.mp4: VP9, AV1 too); index in front
//   .webm       VP9, AV1
//   .mkv        FFV1 version 3, RGB: every code comes back; the others too
// All but FFV1: yuv420p, BT.709 limited range, tagged so. A side of odd length gets its last column or row twice. Colour has
// half the resolution of brightness: neighbouring views of an integral image share it.
// Equal frames and options give equal bytes: no dates, no version strings that change from run to run.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/stereo.hpp"
#include "video/video_codec.hpp"

namespace lippmann {

/// frames per second = numerator / denominator, both > 0.
struct FrameRate {
  int numerator = 25, denominator = 1;
};

/// The nearest fraction; rates as they are usually rounded (29.97, 23.976) become the exact ones (30000/1001, 24000/1001).
FrameRate frame_rate(double frames_per_second);

struct VideoOptions {
  FrameRate rate{};
  std::optional<VideoCodec> codec = {};     ///< none: by the file's ending and the size of frames (video_codec.hpp)
  std::optional<int> crf = {};              ///< constant rate factor, 0 (best) ... 51 or 63; none: the codec's own
  std::optional<StereoLayout> stereo = {};  ///< frames hold two eyes' views; players are told (video/ffmpeg/stereo_tags.hpp)
  int threads = 1;                          ///< the encoder's. H.264's bytes depend on it: never derive it from the machine
};

/// Warns where rows of two eyes go into a video whose neighbouring rows share their colour, and says what keeps them apart.
void warn_of_mixed_rows(const std::filesystem::path& path, const VideoOptions& options, Vec2i size, const Context& context);

/// Throws Error naming the file: for what choose_codec() refuses, a folder that cannot be written, frames that differ in size,
/// a full disk. After an Error only destruction makes sense.
class VideoWriter {
 public:
  explicit VideoWriter(const std::filesystem::path& path, const VideoOptions& options = {});
  /// Without finish() nothing remains.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// The next frame. The first one sets the size.
  void add_frame(const Image8& frame);

  /// Completes the file and puts it under its name. At least one frame must have been added.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Throws what a VideoWriter throws for a file of this name and frames of that size (0: not known), without writing: for checks
/// before a long render.
void check_video_path(const std::filesystem::path& path, const VideoOptions& options = {}, int width = 0, int height = 0);

}  // namespace lippmann
