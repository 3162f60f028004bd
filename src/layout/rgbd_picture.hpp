// An RGB-D picture that is in memory, such as a video's frame, as a light field of one view with depth.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/image/image.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {

/// `file` has the side file that describes the picture, if any (layout/rgbd_side_file.hpp); `where` is what errors name. Throws
/// Error where the picture's width is odd or its right half has colours. A picture whose depth is 0 everywhere is as far as the
/// range goes.
LightField light_field_of_rgbd(const Picture& picture, const std::filesystem::path& file, const std::string& where,
                               const FormatOptions& options);

/// The same of colours and greys from 0 to 1, of one size. `file` has the side file.
LightField light_field_of_colours(Picture colours, Image greys, const std::filesystem::path& file,
                                  const FormatOptions& options);

}  // namespace lippmann
