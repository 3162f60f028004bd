// Where what is computed from light fields goes: pictures of a folder, in linear light until here, and a video of them.
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
    bool exr = false;  ///< linear floats instead of 8-bit sRGB codes as PNG
    std::filesystem::path video = {};
    double frames_per_second = 25.0;
  };

  /// Makes the folders and begins the video. Throws Error naming what cannot be written.
  explicit ReplayFiles(Settings settings);
  ~ReplayFiles();
  ReplayFiles(const ReplayFiles&) = delete;
  ReplayFiles& operator=(const ReplayFiles&) = delete;

  /// Writes name.png or name.exr; `in_video`: also the video's next frame, which must have the size of the others.
  void add(const std::string& name, const Image& picture, bool in_video = false);

  /// Writes name.exr with the one channel Z, mm of the display frame.
  void add_depth(const std::string& name, const Image& depth);

  /// Completes the video; without it, nothing remains of that.
  void finish();

  const std::vector<std::filesystem::path>& written() const { return written_; }

 private:
  Settings settings_;
  NewFolder folder_, video_folder_;
  std::unique_ptr<VideoWriter> video_;
  std::vector<std::filesystem::path> written_;
};

}  // namespace lippmann
