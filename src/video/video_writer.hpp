// Writes frames as a video file: .mp4 (H.264, for watching) or .mkv (FFV1, lossless).
//
//   .mp4  H.264 by libx264, yuv420p, BT.709 limited range, tagged so; index in front. A side of odd length gets its last column
//   or
//         row twice. Colour has half the resolution of brightness: neighbouring views of an integral image share it.
//   .mkv  FFV1 version 3, RGB: every code comes back.
// Equal frames and options give equal bytes: no dates, no version strings that change from run to run.
#pragma once

#include <filesystem>
#include <memory>

#include "image/image.hpp"

namespace lippmann {

/// frames per second = numerator / denominator, both > 0.
struct FrameRate {
  int numerator = 25, denominator = 1;
};

/// The nearest fraction; rates as they are usually rounded (29.97, 23.976) become the exact ones (30000/1001, 24000/1001).
FrameRate frame_rate(double frames_per_second);

struct VideoOptions {
  FrameRate rate{};
  int crf = 18;     ///< H.264 only: constant rate factor, 0 (lossless) ... 51; 18 is hardly told from the original
  int threads = 1;  ///< of the encoder. H.264's bytes depend on it: never derive it from the machine
};

/// Throws Error naming the file: for another extension, a folder that cannot be written, an encoder that this build of FFmpeg
/// lacks, frames that differ in size, a full disk. After an Error only destruction makes sense.
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

/// Throws what the constructor of VideoWriter throws for a file of this name, without writing: for checks before a long render.
void check_video_path(const std::filesystem::path& path);

}  // namespace lippmann
