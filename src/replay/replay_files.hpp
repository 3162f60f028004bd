// Writes the images of a replay to a folder, and optionally a video of them. Images are in linear light.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/folder.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

class VideoWriter;

class ReplayFiles {
 public:
  struct Settings {
    std::filesystem::path folder;
    bool exr = false;  ///< true: writes linear floats (EXR) instead of 8-bit sRGB codes as PNG
    std::filesystem::path video = {};
    double frames_per_second = 25.0;
  };

  /// Makes the folders and begins the video. Throws Error naming a file that cannot be written.
  explicit ReplayFiles(Settings settings);
  ~ReplayFiles();
  ReplayFiles(const ReplayFiles&) = delete;
  ReplayFiles& operator=(const ReplayFiles&) = delete;

  /// Writes name.png or name.exr. in_video: whether to add the image to the video too; all frames of a video must have one
  /// size.
  void add(const std::string& name, const Image& picture, bool in_video = false);

  /// Writes name.exr with one channel Z, in mm of the display frame.
  void add_depth(const std::string& name, const Image& depth);

  /// Completes the video. Without this call the video is discarded.
  void finish();

  const std::vector<std::filesystem::path>& written() const { return written_; }

 private:
  Settings settings_;
  NewFolder folder_, video_folder_;
  std::unique_ptr<VideoWriter> video_;
  std::vector<std::filesystem::path> written_;
};

}  // namespace lippmann
