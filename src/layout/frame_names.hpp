// What the files of an animation's frames are called, as `render` writes them, and finding them in a folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct FrameNames {
  std::string ending = "png";  ///< what pictures end with, without the dot
  std::string suffix = {};     ///< what names of quilts and stereo pictures end with: _qs8x6a0.75, _2x1; else empty
  int views = 0;               ///< above 0: every frame is a folder of so many pictures
  bool is_folder = false;      ///< every frame is a folder whose files a format names (layout/formats.hpp)
};

/// frame_0000.png, .tif or .exr; frame_0000_qs8x6a0.75.png; of views and formats of several files the folder frame_0000.
std::string frame_name(const FrameNames& names, int frame);

/// DIR/frame_0000.png, or DIR/frame_0000/view_000.png and so on. Not for names.is_folder, whose files the format knows.
std::vector<std::filesystem::path> picture_paths(const std::filesystem::path& folder, const FrameNames& names, int frame);

/// Where extra layers of a picture (of a view; -1: of the whole frame) go that are not in the picture itself.
std::filesystem::path layers_path(const std::filesystem::path& folder, int frame, int view = -1);

/// That a frame has: a film of the most rows that pictures have, in bands of 16 rows.
inline constexpr int kMostStrips = 4096;

/// strip_0000_003.exr: rows of a frame that is not joined yet.
std::string strip_name(int frame, int strip);

/// Whether a file is called as strips are.
bool is_strip_name(const std::string& name);

/// The frame that a file of this name, relative to a render's folder, belongs to: a picture, a strip of one, a layer, a side
/// file, a file of a format's folder; none if no render writes files of such a name.
std::optional<int> frame_of_file(const std::string& name);

/// Whether its ending is that of a kind of picture files that the tool reads; letters of either case.
bool is_picture_name(const std::filesystem::path& path);

/// The entries of a folder that are named as frames are, in the order of their numbers: pictures, or folders. Throws Error
/// naming the folder if it cannot be listed, and naming a file of a frame that a render wrote there and that is gone.
std::vector<std::filesystem::path> frame_pictures_in(const std::filesystem::path& folder);
std::vector<std::filesystem::path> frame_folders_in(const std::filesystem::path& folder);

}  // namespace lippmann
