// Pictures with the samples that their file stores, for programs that move pixels without touching them.
#pragma once

#include <filesystem>
#include <variant>

#include "image/image.hpp"

namespace lippmann {

/// 8-bit codes, 16-bit codes, or floats of 3 channels.
using Picture = std::variant<Image8, Image16, Image>;

/// Of more than 3 channels the first three, of fewer the first one three times. Throws Error as read_image.
Picture read_picture(const std::filesystem::path& path);

/// 8- and 16-bit codes as .png, floats as .exr. Throws Error naming the file, also where the ending does not suit.
void write_picture(const std::filesystem::path& path, const Picture& picture);

/// Throws Error if a picture read from `from` cannot be written to `path` without changing samples.
void check_picture_ending(const std::filesystem::path& path, const Picture& picture);

}  // namespace lippmann
