// Finds the pictures that a render has left, with the optics that they were rendered for, and reads them into linear light.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/image/picture_file.hpp"
#include "lippmann/replay/rendered_panel.hpp"

namespace lippmann {

struct RenderedFrames {
  Optics optics;
  std::vector<std::filesystem::path> files;  ///< ascending
  double frames_per_second = 25.0;
};

/// `in`: a picture, or a folder with frame_0000.png (.exr, .tif), ...; report.json lies beside them, or is `report`.
/// Throws Error naming the file: no pictures, no report.json, one that does not say for which optics, or pictures that are not
/// what lies behind a lens array (views, or a quilt of them).
RenderedFrames find_rendered_frames(const std::filesystem::path& in, const std::filesystem::path& report = {});

/// The files alone: a picture, or a folder's. Throws Error naming a folder without.
std::vector<std::filesystem::path> pictures_of(const std::filesystem::path& in);

/// The picture of one of the files, with its samples. Throws Error naming the file, also where its size is not that of the
/// optics' panel.
Picture read_panel_picture(const RenderedFrames& frames, const std::filesystem::path& file);

/// The same in linear light: integer samples are taken for sRGB codes, float samples are linear; what is not finite becomes 0.
/// `index`: of frames.files. Throws Error as read_panel_picture does.
RenderedPanel read_rendered_panel(const RenderedFrames& frames, std::size_t index);

/// What a frame is called in names of files made from it: its number, or a picture's whole name.
std::string frame_label(const std::filesystem::path& file);

}  // namespace lippmann
