// Writes frames as a video file, for viewing (H.264, HEVC, VP9, AV1) or without loss (FFV1).
//
//   .mp4   H.264, HEVC, VP9, AV1; the index is at the start of the file
//   .mov   H.264, HEVC; the index is at the start of the file
//   .webm  VP9, AV1
//   .mkv   FFV1 version 3 (lossless RGB) and all other codecs
// All codecs except FFV1 use yuv420p in BT.709 limited range. yuv420p halves the chroma resolution, so pixels of neighbouring
// views in an integral image share their colour. An odd width or height is padded by repeating the last column or row. Equal
// frames and options give equal bytes.
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

/// Frames per second = numerator / denominator, both > 0.
struct FrameRate {
  int numerator = 25, denominator = 1;
};

/// Returns the fraction nearest to a frame rate. Rounded rates such as 29.97 and 23.976 become exact (30000/1001, 24000/1001).
FrameRate frame_rate(double frames_per_second);

struct VideoOptions {
  FrameRate rate{};
  std::optional<VideoCodec> codec = {};     ///< empty: choose_codec() chooses by the file ending and the frame size
  std::optional<int> crf = {};              ///< constant rate factor, 0 (best) ... 51 or 63; empty: the codec's default
  std::optional<StereoLayout> stereo = {};  ///< layout of stereo frames, written as metadata
  int threads = 1;  ///< encoder threads; H.264's output depends on this number, so do not derive it from the machine
};

/// Warns if row-interleaved stereo is written with chroma subsampling, which mixes the colours of both eyes.
void warn_of_mixed_rows(const std::filesystem::path& path, const VideoOptions& options, Vec2i size, const Context& context);

/// Throws Error naming the file if choose_codec() throws, the folder is not writable, frames differ in size, or the disk is
/// full. After an Error, the object can only be destroyed.
class VideoWriter {
 public:
  explicit VideoWriter(const std::filesystem::path& path, const VideoOptions& options = {});
  /// Removes the unfinished file unless finish() was called.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// The first frame sets the size.
  void add_frame(const Image8& frame);

  /// Moves the file to its final name. Requires at least one frame.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Throws the Error that a VideoWriter would throw for this file and frame size, but writes nothing. A size of 0 means
/// unknown. Call this before a long render.
void check_video_path(const std::filesystem::path& path, const VideoOptions& options = {}, int width = 0, int height = 0);

}  // namespace lippmann
