// Converts an RGB-D picture in memory, such as a video frame, to a light field of one view with depth.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/formats/formats.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// `file`: path whose side file is read, if there is one (formats/rgbd_side_file.hpp). `where`: name of the picture for
/// messages. If the grey half is 0 everywhere, all points lie at one end of the depth range. Throws Error if the
/// picture's width is odd or its right half has colours.
LightField light_field_of_rgbd(const Picture& picture, const std::filesystem::path& file, const std::string& where,
                               const FormatOptions& options);

/// Converts colours and grey values from 0 to 1 of the same size. `file`: path whose side file is read, if there is
/// one.
LightField light_field_of_colours(Picture colours, Image greys, const std::filesystem::path& file,
                                  const FormatOptions& options);

}  // namespace lippmann
