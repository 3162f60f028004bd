// Converts an RGB-D picture in memory, such as a video frame, to a light field of one view with depth.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/image/image.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {

/// Converts a picture. `file` locates the side file, if any (layout/rgbd_side_file.hpp); `where` names the picture in messages.
/// A picture whose depth is 0 everywhere lies at the far end of the range. Throws Error if the picture's width is odd or its
/// right half has colours.
LightField light_field_of_rgbd(const Picture& picture, const std::filesystem::path& file, const std::string& where,
                               const FormatOptions& options);

/// Converts colours and a grey map from 0 to 1 of the same size. `file` locates the side file.
LightField light_field_of_colours(Picture colours, Image greys, const std::filesystem::path& file,
                                  const FormatOptions& options);

}  // namespace lippmann
