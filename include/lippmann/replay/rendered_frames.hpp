// Finds the images of a finished render with their optics, and reads them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/image/picture_file.hpp"
#include "lippmann/replay/rendered_panel.hpp"

namespace lippmann {

struct RenderedFrames {
  Optics optics{};
  std::vector<std::filesystem::path> files{};  ///< in the order of frames
  double frames_per_second = 25.0;
};

/// Finds the frames of `in`: an image, or a folder with frame_0000.png (.exr, .tif), ... An empty `report` means report.json
/// beside the images. Throws Error naming the file if there are no images or no report, if the report has no optics, or if the
/// images have another layout than the panel.
RenderedFrames find_rendered_frames(const std::filesystem::path& in, const std::filesystem::path& report = {});

/// Returns the images in the folder `in`, or `in` itself. Throws Error naming a folder without images.
std::vector<std::filesystem::path> pictures_of(const std::filesystem::path& in);

/// Reads a file without conversion. Throws Error naming the file, for example if its size is not the panel's.
Picture read_panel_picture(const RenderedFrames& frames, const std::filesystem::path& file);

/// Reads frames.files[index] into linear light: integer samples are sRGB codes, and values that are not finite become 0. Throws
/// Error as read_panel_picture() does.
RenderedPanel read_rendered_panel(const RenderedFrames& frames, std::size_t index);

/// Returns the frame's number in the file name, or the whole name if it has no number.
std::string frame_label(const std::filesystem::path& file);

}  // namespace lippmann
