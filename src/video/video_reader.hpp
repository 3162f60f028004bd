// Reads the frames of a video file in any format that FFmpeg supports, in presentation order, as 8-bit RGB codes. YUV without a
// stated matrix and range is taken as BT.601 limited range.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "lippmann/image/image.hpp"

namespace lippmann {

class VideoDecoder;

/// Throws Error naming the file if it is missing, damaged, truncated or not a video, or if frames exceed 65536 pixels a side or
/// 2^28 pixels in total.
class VideoReader {
 public:
  explicit VideoReader(const std::filesystem::path& path);
  ~VideoReader();
  VideoReader(const VideoReader&) = delete;
  VideoReader& operator=(const VideoReader&) = delete;

  std::optional<Image8> next();

 private:
  std::unique_ptr<VideoDecoder> decoder_;
};

/// True for .mp4, .mkv, .mov, .webm, .avi and .m4v.
bool is_video_name(const std::filesystem::path& path);

}  // namespace lippmann
