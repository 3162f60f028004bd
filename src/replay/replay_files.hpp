// Writes the images of a replay, in linear light, to a folder and optionally to a video.
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
    bool exr = false;  ///< writes linear floats (EXR) instead of 8-bit sRGB codes (PNG)
    std::filesystem::path video = {};
    double frames_per_second = 25.0;
  };

  explicit ReplayFiles(Settings settings);
  ~ReplayFiles();
  ReplayFiles(const ReplayFiles&) = delete;
  ReplayFiles& operator=(const ReplayFiles&) = delete;

  /// Writes name.png or name.exr, and with `in_video` a frame of the video. All frames of a video must have one size.
  void add(const std::string& name, const Image& picture, bool in_video = false);

  void add_depth(const std::string& name, const Image& depth);

  /// Completes the video. Without this call, the video is discarded.
  void finish();

  const std::vector<std::filesystem::path>& written() const { return written_; }

 private:
  Settings settings_;
  NewFolder folder_, video_folder_;
  std::unique_ptr<VideoWriter> video_;
  std::vector<std::filesystem::path> written_;
};

}  // namespace lippmann
