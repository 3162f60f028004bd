// Reads the frames of an image, a folder of images or a video, one after another.
//
// The frames of a folder are its images named frame_*, or else all images, in natural order (2 before 10).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

enum class SourceKind { kPicture, kFolder, kVideo };

class FrameSource {
 public:
  struct Item {
    /// File name without folder and extension; frame_0000, frame_0001, ... for videos.
    std::string name;
    /// Reads the image. Thread-safe while the source exists. Throws Error.
    std::function<Image8()> load;
  };

  virtual ~FrameSource() = default;
  virtual SourceKind kind() const = 0;

  /// Returns nullopt after the last frame. Throws Error naming the file.
  virtual std::optional<Item> next() = 0;

  virtual std::vector<std::string> names() const { return {}; }
};

/// Returns the number after "frame_", such as 12 for frame_0012_qs8x6a0.75, or else the number at the end of the name. Returns
/// nullopt if there is none.
std::optional<int> frame_number(const std::filesystem::path& file);

/// `wanted` lists the numbers of the frames to read, ascending; nullopt means all. Throws Error naming `path` if it does not
/// exist, holds no images or two images for one frame, or lacks a wanted frame. next() throws if a video ends too early. `warn`
/// is called on the threads that load the images.
std::unique_ptr<FrameSource> open_frames(const std::filesystem::path& path, const std::optional<std::vector<int>>& wanted = {},
                                         const std::function<void(std::string_view)>& warn = {});

}  // namespace lippmann
