// The names of an animation's frame files, as `render` writes them, and their lookup in a folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct FrameNames {
  std::string ending = "png";  ///< without the dot
  /// Suffix of the names of quilts and stereo pictures, such as _qs8x6a0.75 or _2x1.
  std::string suffix = {};
  int views = 0;           ///< > 0: every frame is a folder that contains this many pictures
  bool is_folder = false;  ///< every frame is a folder whose files are named by a format (formats/formats.hpp)
};

/// Returns, for example, frame_0000.png or frame_0000_qs8x6a0.75.png. For views and formats with several files, returns
/// the name of the folder, frame_0000.
std::string frame_name(const FrameNames& names, int frame);

/// Returns DIR/frame_0000.png, or DIR/frame_0000/view_000.png, ... names.is_folder must be false, because otherwise a format
/// names the files.
std::vector<std::filesystem::path> picture_paths(const std::filesystem::path& folder, const FrameNames& names, int frame);

/// Returns the path of the file for layers, such as depth, that the picture itself does not contain. `view`: number of a view;
/// -1: the whole frame.
std::filesystem::path layers_path(const std::filesystem::path& folder, int frame, int view = -1);

/// Largest number of strips per frame. A film has at most 65536 rows, and a strip at least 16.
inline constexpr int kMostStrips = 4096;

/// Returns, for example, strip_0000_003.exr, the file of some rows of a frame.
std::string strip_name(int frame, int strip);

bool is_strip_name(const std::string& name);

/// Returns the number of the frame that a file of a render belongs to: a picture, strip, layer, side file, or a file in a
/// format's folder. `name` is relative to the render's folder. Returns none if no render writes such a name.
std::optional<int> frame_of_file(const std::string& name);

/// Returns whether the name has the extension of a supported picture format, in any case.
bool is_picture_name(const std::filesystem::path& path);

/// Return the pictures (or the folders) in `folder` that are named like frames, in numerical order. Throw Error if the
/// folder cannot be listed, or if a file that the render's journal lists is missing.
std::vector<std::filesystem::path> frame_pictures_in(const std::filesystem::path& folder);
std::vector<std::filesystem::path> frame_folders_in(const std::filesystem::path& folder);

}  // namespace lippmann
