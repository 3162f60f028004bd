// Reads the frames of a video file of any format that FFmpeg knows, in order of presentation, as 8-bit RGB codes.
//
// YUV is converted by the matrix and range that the stream states; where it states none, BT.601 limited, FFmpeg's default.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "lippmann/image/image.hpp"

namespace lippmann {

class VideoDecoder;

/// Throws Error naming the file if it is missing, not a video, too large (65536 pixels a side, 2^28 pixels), damaged or
/// truncated.
class VideoReader {
 public:
  explicit VideoReader(const std::filesystem::path& path);
  ~VideoReader();
  VideoReader(const VideoReader&) = delete;
  VideoReader& operator=(const VideoReader&) = delete;

  /// The next frame; none after the last one.
  std::optional<Image8> next();

 private:
  std::unique_ptr<VideoDecoder> decoder_;
};

/// Whether the file's extension is that of a video (.mp4, .mkv, .mov, .webm, .avi, .m4v).
bool is_video_name(const std::filesystem::path& path);

}  // namespace lippmann
