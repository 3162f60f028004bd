// The frames of a picture, a folder of pictures or a video, one after the other, whichever it is.
//
// A folder's frames are its pictures called frame_*; where there are none, all its pictures. They are taken in the order of
// their names, numbers in names compared as numbers. Hidden files are left out.
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
    std::string name;              ///< the file's without folder and extension; of a video frame_0000, ...
    std::function<Image8()> load;  ///< its codes; from any thread, while the source lives; throws Error
  };

  virtual ~FrameSource() = default;
  virtual SourceKind kind() const = 0;

  /// None after the last one. Throws Error naming the file.
  virtual std::optional<Item> next() = 0;

  /// The names of all frames, where they are known from the start: not of videos.
  virtual std::vector<std::string> names() const { return {}; }
};

/// The number after frame_, else at the end of a file's name without its ending: 12 of frame_0012 and of a quilt's
/// frame_0012_qs8x6a0.75. None without.
std::optional<int> frame_number(const std::filesystem::path& file);

/// wanted: the frames to take, ascending, by the number after frame_ or at the end of their file's name, of videos by their
/// order from 0; none: all. Throws Error naming `path` if there is nothing there, or a folder without pictures, with two for
/// one frame, or without a wanted one; so does next() of a video that ends before the last wanted frame.
/// `warn`, if given, gets what pictures say and is not honoured, from the threads that load them.
std::unique_ptr<FrameSource> open_frames(const std::filesystem::path& path, const std::optional<std::vector<int>>& wanted = {},
                                         const std::function<void(std::string_view)>& warn = {});

}  // namespace lippmann
