// Writes pictures with opacities.
#pragma once

#include <filesystem>

#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// Like write_picture(). `alpha`: opacities (1 channel, 0 to 1) of a picture of the same size; null: opaque.
void write_picture(const std::filesystem::path& path, Picture picture, const Image* alpha);

}  // namespace lippmann
