// Finds the images of a finished render together with their optics, and reads them into linear light.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/image/picture_file.hpp"
#include "lippmann/replay/rendered_panel.hpp"

namespace lippmann {

struct RenderedFrames {
  Optics optics{};
  std::vector<std::filesystem::path> files{};  ///< images, in ascending order of frames
  double frames_per_second = 25.0;
};

/// Finds the frames of `in`: an image, or a folder with frame_0000.png (.exr, .tif), ... report: the report file; empty:
/// report.json beside the images. Throws Error naming the file if there are no images or no report, if the report has no
/// optics, or if the images are rearranged views instead of the panel's image.
RenderedFrames find_rendered_frames(const std::filesystem::path& in, const std::filesystem::path& report = {});

/// Returns `in` if it is an image, or the images in the folder `in`. Throws Error naming a folder without images.
std::vector<std::filesystem::path> pictures_of(const std::filesystem::path& in);

/// Reads one of frames.files without conversion. Throws Error naming the file, for example if its size is not the panel's.
Picture read_panel_picture(const RenderedFrames& frames, const std::filesystem::path& file);

/// Reads frames.files[index] into linear light: integer samples are sRGB codes, float samples are linear, and values that are
/// not finite become 0. Throws Error as read_panel_picture().
RenderedPanel read_rendered_panel(const RenderedFrames& frames, std::size_t index);

/// Returns the part of a file name that identifies a frame: its number, or the image's whole name if it has no number. The
/// names of files made from the frame contain this part.
std::string frame_label(const std::filesystem::path& file);

}  // namespace lippmann
