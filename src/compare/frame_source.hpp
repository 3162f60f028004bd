// Reads the frames of an image, a folder of images or a video, one after the other.
//
// The frames of a folder are its images named frame_*, or all its images if none has such a name, in natural order of their
// names. Hidden files are skipped.
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
    std::string name;  ///< file name without folder and extension; for videos frame_0000, ...
    /// Returns the frame's codes; may be called from any thread while the source exists; throws Error.
    std::function<Image8()> load;
  };

  virtual ~FrameSource() = default;
  virtual SourceKind kind() const = 0;

  /// Returns the next frame, or none after the last one. Throws Error naming the file.
  virtual std::optional<Item> next() = 0;

  /// Returns the names of all frames. Empty if the names are not known in advance, as for videos.
  virtual std::vector<std::string> names() const { return {}; }
};

/// Returns the number after "frame_", or otherwise the number at the end of the file name without its extension: 12 for
/// frame_0012 and for the quilt frame_0012_qs8x6a0.75. nullopt if there is no number.
std::optional<int> frame_number(const std::filesystem::path& file);

/// Opens a source of frames. wanted: the frames to read, in ascending order, by frame_number() or, for videos, by position from
/// 0; nullopt: all. Throws Error naming `path` if it does not exist, or if it is a folder without images, with two images for
/// one frame, or without a wanted frame. next() throws if a video ends before the last wanted frame. warn: if given, called
/// with warnings about ignored properties of images, on the threads that load them.
std::unique_ptr<FrameSource> open_frames(const std::filesystem::path& path, const std::optional<std::vector<int>>& wanted = {},
                                         const std::function<void(std::string_view)>& warn = {});

}  // namespace lippmann
