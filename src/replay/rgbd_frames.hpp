// The frames of RGB-D pictures or of an RGB-D video, read one at a time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/layout/formats.hpp"
#include "video/video_reader.hpp"

namespace lippmann {

struct RgbdFrame {
  std::filesystem::path name;  ///< a file's name; a video's frames are called frame_0000.png, frame_0001.png, ...
  LightField field;            ///< one view with depth
};

class RgbdFrames {
 public:
  /// `in`: a picture, a folder of frame_*_rgbd.png, or a video, whose side file describes all of its frames. Throws Error if
  /// there is no such file, or no frame in the folder.
  RgbdFrames(const std::filesystem::path& in, const FormatOptions& options);

  /// The next frame; none after the last one. Throws Error naming the file, and of videos the frame.
  std::optional<RgbdFrame> next();

  /// The file whose side file says how deep the first frame is.
  const std::filesystem::path& first() const { return files_.front(); }
  /// Whether `in` is one picture, not a sequence of them.
  bool is_one_picture() const { return one_; }

 private:
  std::optional<RgbdFrame> next_of_video();

  std::vector<std::filesystem::path> files_;
  FormatOptions options_;
  bool one_;
  std::optional<VideoReader> video_;
  std::size_t count_ = 0;  ///< how many have been read
};

}  // namespace lippmann
