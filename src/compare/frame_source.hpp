// Reads the frames of an image, a folder of images or a video, one after another.
//
// The frames of a folder are its images named frame_*. If no image has such a name, all images are frames. Frames are sorted by
// name in natural order (2 before 10). Hidden files are skipped.
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
    /// File name without folder and extension. Frames of videos are named frame_0000, frame_0001, ...
    std::string name;
    /// Returns the frame's codes. May be called from any thread while the source exists. Throws Error.
    std::function<Image8()> load;
  };

  virtual ~FrameSource() = default;
  virtual SourceKind kind() const = 0;

  /// Returns the next frame, or nullopt after the last frame. Throws Error that names the file.
  virtual std::optional<Item> next() = 0;

  /// Returns the names of all frames. Returns nothing if the names are not known in advance, as for videos.
  virtual std::vector<std::string> names() const { return {}; }
};

/// Returns the number after "frame_", such as 12 for frame_0012 and for the quilt frame_0012_qs8x6a0.75. For other names,
/// returns the number at the end of the file name without its extension. Returns nullopt if there is no number.
std::optional<int> frame_number(const std::filesystem::path& file);

/// Opens a source of frames. `wanted` lists the frames to read, in ascending order: frame_number(), or the position from 0 in a
/// video. If `wanted` is nullopt, all frames are read. Throws Error that names `path` if `path` does not exist. Also throws if
/// the folder holds no images, holds two images for one frame, or lacks a wanted frame. next() throws if a video ends before
/// the last wanted frame. `warn` may be empty. It is called with warnings about ignored properties of images, on the threads
/// that load the images.
std::unique_ptr<FrameSource> open_frames(const std::filesystem::path& path, const std::optional<std::vector<int>>& wanted = {},
                                         const std::function<void(std::string_view)>& warn = {});

}  // namespace lippmann
